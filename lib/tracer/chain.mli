(** Chains of rays, of which each is sent on by the hit of the one before.

    They are followed by recursion. Natively the stack has room for chains of
    {!Raylab_scene.Scene.max_ray_depth} rays, unless somebody makes it smaller;
    that of JavaScript has it for some hundreds. *)

exception Too_long of { ray_depth : int }
(** [Too_long { ray_depth }] is raised in place of a colour if the chain of a
    ray, in a scene with that ray depth, does not fit on the stack. *)

val too_long : ray_depth:int -> string
(** [too_long ~ray_depth] says so to the user, and what to do. *)
