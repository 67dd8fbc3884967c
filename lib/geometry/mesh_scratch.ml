type t = { stack : int array; mutable top : int; sheared : Triangle_ray.t }

let max_depth = 91

(* The bottom of the stack is a node that is none. *)
let create () =
  {
    stack = Array.make (max_depth + 1) min_int;
    top = 0;
    sheared = Triangle_ray.create ();
  }
