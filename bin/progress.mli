(** A line on the terminal that tells how far a rendering is. *)

type t
(** The type for progress lines. *)

val start : quiet:bool -> t
(** [start ~quiet] is a new progress line. It is shown on standard error,
    unless [quiet] or standard error is not a terminal. *)

val update : t -> float -> unit
(** [update line part] shows that [part] of the work, from 0 to 1, is done, and
    how long the rest will take if it goes on like that. *)

val clear : t -> unit
(** [clear line] takes the line from the terminal. *)

val leave : t -> unit
(** [leave line] ends the line as it stands, for a program that ends now; it
    waits for nobody. *)
