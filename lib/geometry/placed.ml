type 'shape t = {
  own : 'shape;
  modifiers : Change.modifier list;
  out : Affine.t;
  back : Affine.t;
}

let make change own =
  let out = Change.affine change in
  match Affine.inverse out with
  | Some back -> { own; modifiers = Change.modifiers change; out; back }
  | None -> invalid_arg "a change that cannot be undone in numbers"

let change second { own; modifiers; _ } =
  make (Change.compose second (Change.of_modifiers modifiers)) own

let with_own own placed = { placed with own }

(* {1 What is hit} *)

(* More than any rounding error of a distance. *)
let slack = 1. +. 0x1p-40

(* A length is no number to divide by where the numbers of a change are beyond
   squares; such a shape is not met. *)
let[@inline] is_length x = x > 0. && x < infinity

let[@inline] restore (ray : Raw_ray.t) ox oy oz dx dy dz reach =
  Raw_ray.set_origin ray ox oy oz;
  Raw_ray.set_direction ray dx dy dz;
  ray.reach <- reach

(* The own shape is asked alone, and what it says then told as a distance of
   the ray itself, so that the answer does not depend on what was asked
   before. *)
let offer own_offer { own; back; _ } (ray : Raw_ray.t) (meeting : Meeting.t)
    ~number =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; reach; _ } = ray in
  let length = Affine.stretch back ray in
  if is_length length then (
    let { Meeting.number = met_number; part = met_part; _ } = meeting in
    Affine.bring back ray length;
    ray.reach <- reach *. length *. slack;
    Meeting.clear meeting;
    own_offer own ray meeting ~number;
    let is_met = not (Meeting.is_none meeting)
    and part = meeting.part
    and t = ray.reach /. length in
    restore ray ox oy oz dx dy dz reach;
    meeting.number <- met_number;
    meeting.part <- met_part;
    if is_met then Meeting.offer meeting ray ~number ~part t)

let settle own_settle { own; out; back; _ } ~part (ray : Raw_ray.t) spot =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; reach; _ } = ray in
  let length = Affine.stretch back ray in
  Affine.bring back ray length;
  ray.reach <- reach *. length;
  own_settle own ~part ray spot;
  restore ray ox oy oz dx dy dz reach;
  Affine.bring_spot ~out ~back ray spot

let crossings own_crossings { own; back; _ } (ray : Raw_ray.t) found =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; reach; _ } = ray in
  let length = Affine.stretch back ray in
  if is_length length then (
    Affine.bring back ray length;
    own_crossings own ray found;
    Crossings.divide found length;
    restore ray ox oy oz dx dy dz reach)
  else Crossings.clear found ~starts_inside:false

(* {1 Where it is} *)

let corners { Box3.low; high } =
  let of_x x =
    List.concat_map
      (fun y -> [ Vec3.make x y low.z; Vec3.make x y high.z ])
      [ low.y; high.y ]
  in
  of_x low.x @ of_x high.x

(* Wider by more than the rounding errors of what lies on the shape. *)
let margin = 0x1p-44

let around points =
  let pick f coordinate =
    List.fold_left f
      (coordinate (List.hd points))
      (List.map coordinate (List.tl points))
  in
  let all f =
    Vec3.make
      (pick f (fun (p : Vec3.t) -> p.x))
      (pick f (fun (p : Vec3.t) -> p.y))
      (pick f (fun (p : Vec3.t) -> p.z))
  in
  let low = all Float.min and high = all Float.max in
  let wider =
    let w = margin *. Float.max (Vec3.magnitude low) (Vec3.magnitude high) in
    Vec3.make w w w
  in
  Box3.make ~low:(Vec3.sub low wider) ~high:(Vec3.add high wider)

let box own { out; _ } = around (List.map (Affine.point out) (corners own))

let depth own_depth { own; back; _ } point =
  own_depth own (Affine.point back point) /. Affine.size back

let plane { own; out; back; _ } =
  let { Plane.point; normal } = own in
  Plane.make ~point:(Affine.point out point)
    ~normal:(Direction.of_vec3_exn (Affine.covector back (normal :> Vec3.t)))
