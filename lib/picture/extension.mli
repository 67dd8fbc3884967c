(** Extensions of the names of files that are to be written. *)

val of_path : string -> (string, string) result
(** [of_path path] is the extension of [path] in lower case, such as [".png"],
    or [""] if there is none; or a message if the name is nothing else, such as
    [.png], which can hardly be meant. *)
