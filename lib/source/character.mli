(** Characters that one takes for others, or does not see at all.

    Web pages, word processors and keyboards of other scripts put them into
    texts; no word of the scene language has one. *)

val strange : int -> (string * string) option
(** [strange code] is the name of the character of [code], such as
    ["a minus sign"], and what it was meant for: ["-"]; [" "] for a space and
    [""] for what is not seen. It is [None] for all other characters, those of
    ASCII that are seen among them. *)

val is_unseen : int -> bool
(** [is_unseen code] is whether the character of [code] shows nothing, or even
    governs how others are shown: control characters, ends of lines, marks of
    direction and the like. A space is no such character. *)
