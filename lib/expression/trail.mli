(** The calls and rounds that are going on, as data: what led to an error, or
    made an object. All that happens in one call shares its trail. *)

(** The type for trails, the innermost first. Offsets are those of
    {!Raylab_source.Files}. *)
type t =
  | Start  (** no call and no round *)
  | Call of {
      name : string;
      arguments : (string * Datum.t) list;  (** those that are given *)
      at : int;  (** where it is called *)
      around : t;
    }
  | Round of { loop : loop; value : Datum.t; around : t }

and loop = {
  name : string;
  at : int;  (** where the loop introduces the name *)
}

val around : t -> t
(** [around trail] is [trail] without its innermost call or round. *)

val length : t -> int
(** [length trail] is how many calls and rounds it has. *)

val apart : t -> from:t -> t list
(** [apart trail ~from] is [trail] and what is around it, the innermost first,
    as far as it is not around [from], too. *)
