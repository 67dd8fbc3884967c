(** The way of a ray through a tree. *)

type spheres = {
  tree : Bvh_tree.t;
  numbers : int array;  (** by place *)
  rows : float array;
      (** x, y, z and radius of the sphere at each place, if there are any *)
}
(** A tree, and the spheres in its leaves. *)

val start :
  any:bool -> spheres -> Mesh_scratch.t -> Raw_ray.t -> Meeting.t -> int
(** [start ~any spheres walk ray meeting] goes through the tree, the nearer
    child of each node first, and lets spheres offer what [ray] meets. It stops
    at the first leaf of others, and with [any] at the first leaf where a
    sphere is met. Its result is that leaf, or {!Bvh_tree.none}. *)

val go_on :
  any:bool -> spheres -> Mesh_scratch.t -> Raw_ray.t -> Meeting.t -> int
(** [go_on ~any spheres walk ray meeting] goes on after such a leaf; [walk]
    says where. *)
