(** Warnings: what is allowed but hardly meant, and how it is worded. *)

type t = {
  text : string;
  about : Origin.t list;  (** of what it speaks of, as far as that has one *)
}
(** The type for warnings. *)

val to_string : (Origin.t -> Provenance.t option) -> t -> string
(** [to_string provenance warning] is its text with the places of what it
    speaks of, as far as they are known: ["text (lines 4 and 9)"]. *)

val few : string -> ('a -> t) -> 'a list -> t list
(** [few noun sentence items] is [sentence] of each of the first ten of
    [items], and how many more there are, [noun] being what one is:
    ["3 more lights are like that"]. *)

val name : int -> Object.t -> string
(** [name number o] is what object [number] is called: ["sphere 3"]. *)
