open Raylab_geometry
open Raylab_expression
open Raylab_scene

type grouping = Together | Solid of Solid.operation

type t = Surface of Surface.t | Light of placeable | Object of placeable
and placeable = { node : node; born : int }

and node =
  | Leaf of Object.t
  | Lamp of Light.t
  | Group of {
      grouping : grouping;
      origin : Origin.t;
      nodes : node list;
      size : size;
    }
  | Changed of { change : Change.t; node : node; size : size }
  | Named of { named : named; node : node; size : size }
  | Shadowless of { node : node; size : size }
  | Unfading of { node : node; size : size }

and size = {
  count : int;
  visits : int;
  depth : int;
  shines : bool;
  unfit : unfit option;
}

and unfit = { what : string; why : string; advice : string }
and named = { name : string; at : int; within : Trail.t }

let a word =
  match word.[0] with
  | 'a' | 'e' | 'i' | 'o' -> "an " ^ word
  | _ -> "a " ^ word

let word = function
  | Together -> "group"
  | Solid operation -> Solid.word operation

(* {1 What cannot be part of a solid} *)

let light =
  {
    what = "a light";
    why = "has no inside";
    advice = "put it before or after, or into a group around both";
  }

let flat shape =
  {
    what = a (Shape.name shape);
    why = "has no inside";
    advice = "a flat shape cannot cut or be cut: take a thin box or cylinder";
  }

let open_ opening =
  {
    what = "this mesh";
    why = "is not closed: " ^ Raylab_source.Printable.text opening;
    advice =
      "a mesh has an inside if each edge, by where it is, has exactly two \
       faces";
  }

let casts_none =
  {
    what = "what is shadowless";
    why = "would leave a hole in the shadow of the whole";
    advice = "write shadowless after the end, for the whole";
  }

let unfit_object (o : Object.t) =
  if o.is_shadowless then Some casts_none
  else if Shape.is_solid o.shape then None
  else
    Some (Option.fold ~none:(flat o.shape) ~some:open_ (Shape.opening o.shape))

let unfit = function
  | Leaf o -> unfit_object o
  | Lamp _ -> Some light
  | Group { size; _ }
  | Changed { size; _ }
  | Named { size; _ }
  | Shadowless { size; _ }
  | Unfading { size; _ } ->
      size.unfit

(* {1 Sizes} *)

let one = { count = 1; visits = 1; depth = 0; shines = false; unfit = None }
let one_light = { one with shines = true }

let size = function
  | Leaf _ -> one
  | Lamp _ -> one_light
  | Group { size; _ }
  | Changed { size; _ }
  | Named { size; _ }
  | Shadowless { size; _ }
  | Unfading { size; _ } ->
      size

(* Groups of groups double what they have, also if that is nothing. *)
let most_visits = 1_000_000_000
let visits a b = Int.min most_visits (a + b)

let around node =
  let size = size node in
  { size with visits = visits 1 size.visits; unfit = unfit node }

let leaf o = Leaf o
let lamp l = Lamp l

let again (within : Trail.t) node =
  match (within, node) with
  | Start, _ | _, (Group _ | Changed _ | Named _ | Shadowless _ | Unfading _)
    ->
      node
  | _, Leaf o -> Leaf (Object.with_origin (Origin.again within o.origin) o)
  | _, Lamp l -> Lamp (Light.with_origin (Origin.again within l.origin) l)

let group ~origin grouping nodes =
  let add total node =
    let size = size node in
    {
      total with
      count = total.count + size.count;
      visits = visits total.visits size.visits;
      depth = Int.max total.depth (size.depth + 1);
      shines = total.shines || size.shines;
    }
  in
  let empty =
    let unfit = List.find_map unfit nodes in
    { count = 0; visits = 1; depth = 1; shines = false; unfit }
  in
  let size = List.fold_left add empty nodes in
  Group { grouping; origin; nodes; size }

let changed change node = Changed { change; node; size = around node }
let named named node = Named { named; node; size = around node }

let shadowless node =
  Shadowless { node; size = { (around node) with unfit = Some casts_none } }

let unfading node = Unfading { node; size = around node }

let describe = function
  | Surface _ -> "a surface"
  | Light _ -> "a light"
  | Object _ -> "an object"
