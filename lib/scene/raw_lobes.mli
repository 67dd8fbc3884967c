(** Lobes as numbers in a row, for inner loops: surfaces write what they denote
    there, and nothing is allocated.

    A row is {!size} numbers of an array from some place on: red, green and
    blue of each lobe, from {!emission}, {!albedo} and {!mirror} on. Rows
    follow one another, so that a scene has all of its in one array, where they
    are found with the fewest misses of the cache; and a mix has its parts
    written into the row after its own, one after another, and adds them up. *)

val emission : int
(** [emission] is 0. *)

val albedo : int
(** [albedo] is 3. *)

val mirror : int
(** [mirror] is 6. *)

val size : int
(** [size] is 9. *)

val create : rows:int -> float array
(** [create ~rows] is so many rows, all lobes zero. *)

val clear : float array -> int -> unit
(** [clear numbers at] makes all lobes of the row at [at] zero. *)

val set : float array -> int -> Color.t -> unit
(** [set numbers at color] writes [color] at [at]: that of a row and of one of
    its lobes. *)

val add_next : float array -> int -> float -> unit
(** [add_next numbers at weight] adds [weight] times the row after the one at
    [at] to that; numbers too large for a double become the largest finite one.
*)

val read : float array -> int -> Lobes.t
(** [read numbers at] is the lobes of the row at [at]. *)
