open Raylab_geometry

type t = {
  shape : Shape.t;
  surface : Surface.t;
  primitives : t array;
  is_shadowless : bool;
  origin : Origin.t;
}

let make ?(origin = Origin.Unknown) shape surface =
  (match shape with
  | Shape.Solid _ -> invalid_arg "a solid is made of objects"
  | _ -> ());
  { shape; surface; primitives = [||]; is_shadowless = false; origin }

let rec primitives_of : t Solid.tree -> t list = function
  | Member ({ primitives = [||]; _ } as o) -> [ o ]
  | Member { primitives; _ } -> Array.to_list primitives
  | Combined (_, parts) -> List.concat_map primitives_of parts

let solid ?(origin = Origin.Unknown) tree =
  match primitives_of tree with
  | [] -> invalid_arg "a solid of no primitive"
  | first :: _ as primitives ->
      {
        shape = Shape.solid (Solid.map_tree (fun o -> o.shape) tree);
        surface = first.surface;
        primitives = Array.of_list primitives;
        is_shadowless = false;
        origin;
      }

let primitive o = function None -> o | Some k -> o.primitives.(k - 1)
let with_origin origin o = { o with origin }
let shadowless o = { o with is_shadowless = true }

let surfaces o =
  match o.primitives with
  | [||] -> [ o.surface ]
  | primitives -> List.map (fun o -> o.surface) (Array.to_list primitives)

let rec map_surfaces f o =
  {
    o with
    surface = f o.surface;
    primitives = Array.map (map_surfaces f) o.primitives;
  }

let with_surface surface = map_surfaces (fun _ -> surface)

let rec transformed change o =
  match o.primitives with
  | [||] ->
      let keep_own = Surface.varies o.surface in
      { o with shape = Shape.transformed ~keep_own change o.shape }
  | primitives ->
      let primitives = Array.map (transformed change) primitives in
      let shapes = Array.map (fun o -> o.shape) primitives in
      { o with primitives; shape = Shape.with_members shapes o.shape }

let rec equal a b =
  Shape.equal a.shape b.shape
  && Surface.equal a.surface b.surface
  && a.is_shadowless = b.is_shadowless
  && List.equal equal (Array.to_list a.primitives) (Array.to_list b.primitives)

let pp ppf ({ shape; surface; is_shadowless; _ } as o) =
  Shape.pp ppf shape;
  (match o.primitives with
  | [||] -> Format.fprintf ppf ", %a" Surface.pp surface
  | primitives ->
      Array.iteri
        (fun k o ->
          Format.fprintf ppf "%s %a"
            (if k = 0 then ":" else ",")
            Surface.pp o.surface)
        primitives);
  if is_shadowless then Format.fprintf ppf ", shadowless"
