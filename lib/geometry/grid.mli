(** A grid of cells in space: what a ray hits among shapes that lie about like
    gravel, not like a skin.

    Each cell lists the shapes that reach into it, and a ray goes from cell to
    cell (J. Amanatides and A. Woo, A Fast Voxel Traversal Algorithm for Ray
    Tracing, 1987). There are about as many cells as shapes; a cell that holds
    many small ones has a grid of its own. *)

type t
(** The type for grids. *)

val make : Leaves.t -> t option
(** [make leaves] is the grid of [leaves]; [None] if it would take more than 8
    references a leaf, since too many are much larger than others, or numbers
    beyond 1e100. *)

val cost : t -> float
(** [cost grid] is about how long a ray that crosses its box is on the way, in
    steps of {!Bvh.cost}, if it hits nothing. *)

(** {1 Questions}

    They are answered as {!Bvh} answers them, for rays that come from near
    enough. *)

val has_ray_from : t -> Raw_ray.t -> bool
(** [has_ray_from grid ray] is whether [ray] starts near enough: rounding
    errors on its way are far less than what cells are larger by. *)

val nearest : t -> Leaves.t -> Raw_ray.t -> Meeting.t -> unit
(** [nearest grid leaves ray meeting] lets the shapes that [ray] can hit nearer
    than what it is known to hit offer where they are met. *)

val some : t -> Leaves.t -> Raw_ray.t -> Meeting.t -> unit
(** [some grid leaves ray meeting] is the same until one is met. *)
