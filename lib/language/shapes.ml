open Raylab_geometry
open Written

let sphere centre radius =
  let make centre radius = Shape.sphere ~centre ~radius in
  Written
    {
      make;
      parameters =
        [ vector "the centre" centre; number Positive "the radius" radius ];
    }

let plane point normal =
  let make point normal = Shape.plane ~point ~normal in
  Written
    {
      make;
      parameters = [ vector "the point" point; direction "the normal" normal ];
    }

(* What the parameters are together may be no shape, though each is right. *)
let fitting ~advice make =
  try make () with Invalid_argument message -> refuse message ~advice

let box corner opposite =
  let make corner opposite =
    fitting
      ~advice:
        "the corners of a box differ in x, y and z. What is flat is a quad"
      (fun () -> Shape.box_between ~corner ~opposite)
  in
  Written
    {
      make;
      parameters =
        [ vector "a corner" corner; vector "the opposite corner" opposite ];
    }

let ends = "give two points that differ: the axis goes from one to the other"

let cylinder a b radius =
  let make a b radius =
    fitting ~advice:ends (fun () -> Shape.cylinder a b ~radius)
  in
  Written
    {
      make;
      parameters =
        [
          vector "the first end" a;
          vector "the second end" b;
          number Positive "the radius" radius;
        ];
    }

let cone a radius_a b radius_b =
  let make a radius_a b radius_b =
    if radius_a = 0. && radius_b = 0. then
      refuse "both radii of a cone are 0"
        ~advice:"one of them may be 0, which makes a tip"
    else fitting ~advice:ends (fun () -> Shape.cone a radius_a b radius_b)
  in
  Written
    {
      make;
      parameters =
        [
          vector "the first end" a;
          number Non_negative "the radius at the first end" radius_a;
          vector "the second end" b;
          number Non_negative "the radius at the second end" radius_b;
        ];
    }

let torus centre axis ring tube =
  let make centre axis ring tube =
    fitting
      ~advice:
        "the radius of the ring comes first: torus CENTRE AXIS RADIUS \
         RADIUS_OF_TUBE" (fun () -> Shape.torus ~centre ~axis ~ring ~tube)
  in
  Written
    {
      make;
      parameters =
        [
          vector "the centre" centre;
          direction "the axis" axis;
          number Positive "the radius of the ring" ring;
          number Positive "the radius of the tube" tube;
        ];
    }

let disc centre normal radius =
  let make centre normal radius = Shape.disc ~centre ~normal ~radius in
  Written
    {
      make;
      parameters =
        [
          vector "the centre" centre;
          direction "the normal" normal;
          number Positive "the radius" radius;
        ];
    }

let triangle a b c =
  let make a b c =
    fitting ~advice:"give three points that do not lie on one line" (fun () ->
        Shape.triangle a b c)
  in
  Written
    {
      make;
      parameters =
        [
          vector "the first corner" a;
          vector "the second corner" b;
          vector "the third corner" c;
        ];
    }

let quad corner edge other =
  let make corner edge other =
    fitting
      ~advice:
        "the edges begin at the corner and go two ways: quad CORNER EDGE EDGE"
      (fun () -> Shape.quad ~corner ~edge ~other)
  in
  Written
    {
      make;
      parameters =
        [
          vector "the corner" corner;
          direction "the first edge" edge;
          direction "the second edge" other;
        ];
    }

let mesh model ~is_smooth =
  let mesh = Raylab_mesh_file.Model.mesh model ~is_smooth in
  Written { make = Shape.Mesh mesh; parameters = [] }
