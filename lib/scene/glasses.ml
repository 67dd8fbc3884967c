open Raylab_geometry

let least_ray_depth = 8

(* Of one that varies, what it is made of. *)
let has holds surface =
  let has_at_once surface =
    List.exists holds (Surface.lobes surface).refractions
  in
  (not (Surface.is_plain surface))
  &&
  if Surface.varies surface then
    List.exists has_at_once (Surface.simple surface)
  else has_at_once surface

let is_glass =
  has (fun { Lobes.fresnel; glass; _ } ->
      Color.largest fresnel > 0. || Color.largest glass > 0.)

let is_clear =
  has (fun { Lobes.plain; glass; _ } ->
      Color.largest plain > 0. || Color.largest glass > 0.)

let lets_through o =
  let may surface = Surface.varies surface || is_clear surface in
  List.exists may (Object.surfaces o)

let sentence (number, (o : Object.t)) =
  let text =
    Printf.sprintf
      "%s is of glass, but does not close: what goes in never comes out. \
       Glass is for closed shapes, such as a sphere or a thin box"
      (Warning.name number o)
  in
  { Warning.text; about = [ o.origin ] }

let shallow ray_depth =
  {
    Warning.text =
      Printf.sprintf
        "raydepth is %d: in glass many chains of rays end early, and show the \
         background; say raydepth 8 or more"
        ray_depth;
    about = [];
  }

let warnings ~ray_depth objects =
  let number k o = (k + 1, o) in
  let of_glass (_, o) = List.exists is_glass (Object.surfaces o) in
  let glasses = List.filter of_glass (List.mapi number objects) in
  let is_open (_, (o : Object.t)) = not (Shape.is_solid o.shape) in
  (if glasses <> [] && ray_depth < least_ray_depth then [ shallow ray_depth ]
   else [])
  @ Warning.few "object" sentence (List.filter is_open glasses)
