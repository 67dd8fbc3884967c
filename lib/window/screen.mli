(** The size of the screen, which Graphics does not tell.

    The X server says it when a program connects, so this connects, listens and
    goes, as the protocol has it (X Window System Protocol, version 11, chapter
    8). *)

val size : unit -> (int * int) option
(** [size ()] is width and height of the screen in pixels, or [None] if they
    cannot be found out. *)

(** {1 Its parts} *)

type address = { host : string; display : int }
(** Where a display is; [host] is [""] for this machine. *)

val address : string -> address option
(** [address display] is what a [DISPLAY] such as [:0] or [there:10.0] says. *)

val cookie : display:int -> string -> string option
(** [cookie ~display file] is the secret with which one may connect to display
    [display], in the contents of an [.Xauthority] file: its first
    [MIT-MAGIC-COOKIE-1] for a display of this number. *)

val size_in_reply : string -> (int * int) option
(** [size_in_reply body] is the size of the first screen in what the server
    answers to a new connection, without the first 8 bytes. *)
