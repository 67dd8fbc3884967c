(** Lobes as numbers in a row, for inner loops: a surface writes what it
    denotes there, and nothing is allocated but where the room has to grow.

    What every surface has is its {e core}, a row of {!size} numbers: red,
    green and blue of each lobe, from {!emission}, {!albedo} and {!mirror} on.
    A scene has the cores of its surfaces in one array, one after another. What
    varies in number lies apart, so that plain surfaces pay nothing for it. *)

(** {1 The core} *)

val emission : int
(** [emission] is 0. *)

val albedo : int
(** [albedo] is 3. *)

val mirror : int
(** [mirror] is 6. *)

val size : int
(** [size] is 9. *)

(** {1 All lobes of a surface} *)

type t = private {
  mutable core : float array;
      (** the core of the surface, and after it rows in which mixes are worked
          out *)
  mutable opened : int array;
      (** how many highlights and refractions there were when each row was
          opened *)
  highlights : Raw_parts.t;  (** the sharpness and one colour each *)
  refractions : Raw_parts.t;
      (** the index and three colours each, from {!plain}, {!fresnel} and
          {!glass} on; see {!Lobes.refraction} *)
}
(** The type for registers of the lobes of a surface. *)

val plain : int
(** [plain] is 1. *)

val fresnel : int
(** [fresnel] is 4. *)

val glass : int
(** [glass] is 7. *)

val create : unit -> t
(** [create ()] is a new register, of a surface that does nothing. *)

val is_plain : t -> bool
(** [is_plain raw] is whether there is nothing but the core. *)

val read : t -> Lobes.t
(** [read raw] is the lobes that [raw] holds. *)

(** {1 Writing}

    For {!Surface.write}. A mix has its parts written into the row after its
    own, one after another, and adds up each. *)

val clear : t -> unit
(** [clear raw] makes [raw] one of no highlight and no refraction. *)

val open_row : t -> int -> unit
(** [open_row raw row] makes the core of this row, counted from 0, black. *)

val set : t -> int -> int -> Color.t -> unit
(** [set raw row lobe color] writes [color] into the row at {!emission},
    {!albedo} or {!mirror}. *)

val add_highlight : t -> sharpness:float -> Color.t -> unit
(** [add_highlight raw ~sharpness color] adds this highlight. *)

val add_refractive : t -> index:float -> Color.t -> unit
(** [add_refractive raw ~index color] adds a refraction in this {!plain}
    colour. *)

val add_glass : t -> index:float -> Color.t -> unit
(** [add_glass raw ~index color] adds a refraction of glass in this colour,
    which mirrors all that it does not let through. *)

val mix : t -> int -> Color.t -> unit
(** [mix raw row weight] adds [weight] times what has been written since the
    row after [row] was opened to what has been since [row] was: the one core
    to the other, and each highlight and refraction to the one of the same key,
    if there is one. Numbers too large for a double become the largest finite
    one. *)
