(** Options that several sub-commands have, and what they are made of. *)

open Cmdliner

(** {1 Which picture} *)

type view
(** The type for what changes the picture of a scene: options --size, --grey,
    --samples, --exposure and --srgb. *)

val view : view Term.t
(** [view] is these options. *)

val is_grey : view -> bool
(** [is_grey view] is whether option --grey is given. *)

val arguments : view -> string list
(** [arguments view] is how a command line says it. *)

val adjust : view -> Raylab_scene.Scene.t -> Raylab_scene.Scene.t
(** [adjust view scene] is [scene] as the options want it. *)

val adjust_colored : view -> Raylab_scene.Scene.t -> Raylab_scene.Scene.t
(** [adjust_colored view scene] is likewise, but for its colours, which stay as
    they are written. *)

val distortion : view -> Raylab_scene.Scene.t -> string option
(** [distortion view scene] says if the size that is asked for distorts the
    picture of [scene], which {!adjust} has not yet changed, otherwise than its
    own size does. *)

(** {1 Which files} *)

val allow : string list Term.t
(** [allow] is option --allow: folders that files may be in that the scene
    names. *)

val from_prompt : bool Term.t
(** [from_prompt] is option --from-prompt, which no manual tells of: the scene
    is one that the prompt hands over. See {!Raylab_toplevel.Handover}. *)

(** {1 How it is computed} *)

val domains : int option Term.t
(** [domains] is option --domains. *)

val number_of_domains : int Arg.conv
(** [number_of_domains] converts what option --domains takes. *)

(** {1 Numbers} *)

val conv :
  (string -> ('a, string) result) ->
  (Format.formatter -> 'a -> unit) ->
  docv:string ->
  'a Arg.conv
(** [conv parse print ~docv] converts arguments by [parse], whose errors are
    messages. *)

val natural : string -> int option
(** [natural text] is the number that [text] is, if it is nothing but digits.
*)

val pair : char -> string -> (int * int) option
(** [pair separator text] is the two naturals in a text such as [640x480]. *)
