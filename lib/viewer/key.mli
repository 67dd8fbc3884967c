(** The keys of the window. *)

type t =
  | Save
  | Render
  | Toggle_path
  | Clear
  | Nearer
  | Farther
  | Back
  | Print_view
  | Help
  | Close  (** The type for what a key is for. *)

val of_char : char -> t option
(** [of_char c] is what the key that types [c], be it with Caps Lock, is for;
    none for most. *)

val help : string
(** [help] is lines that tell what there is to press and to click. *)
