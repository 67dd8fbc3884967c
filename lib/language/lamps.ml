open Raylab_scene
open Written

let intensity = number Non_negative "the intensity"
let color = color "the light's colour"

let directional i c direction_ =
  let make intensity color direction =
    Light.directional ~intensity ~color ~direction
  in
  Written
    {
      make;
      parameters =
        [ intensity i; color c; direction "the direction" direction_ ];
    }

(* As OCaml writes it: %g of a number of degrees. *)
let degrees = Printf.sprintf "%g"

let refused ~inner ~outer : Beam.problem -> _ = function
  | Not_below_180 ->
      Written.refuse
        (Printf.sprintf "the outer angle must be less than 180 degrees, not %s"
           (degrees outer))
        ~advice:"it is measured from the axis: 90 lights all that is before it"
  | Inner_beyond_outer ->
      Written.refuse
        (Printf.sprintf
           "the inner angle, %s degrees, is greater than the outer one, %s"
           (degrees inner) (degrees outer))
        ~advice:
          "the inner angle comes first: spot INTENSITY COLOUR POINT TARGET \
           INNER OUTER"
  | No_axis | Not_finite ->
      Written.refuse "the light and its target are one point, or too far apart"
        ~advice:
          "give two points that differ: the light shines from one at the other"

let spot i c position_ target_ inner_ outer_ =
  let make intensity color position target inner outer =
    match Beam.make ~position ~target ~inner ~outer with
    | Ok beam -> Light.spot ~intensity ~color beam
    | Error problem -> refused ~inner ~outer problem
  in
  Written
    {
      make;
      parameters =
        [
          intensity i;
          color c;
          vector "the light's position" position_;
          vector "the light's target" target_;
          number Non_negative "the inner angle" inner_;
          number Non_negative "the outer angle" outer_;
        ];
    }

let area i c corner_ edge_ other_ count_ =
  let make intensity color corner edge other count =
    match Pane.make ~corner ~edge ~other ~count with
    | pane -> Light.area ~intensity ~color pane
    | exception Invalid_argument _ ->
        Written.refuse "the corners of the area light are too far away"
  in
  Written
    {
      make;
      parameters =
        [
          intensity i;
          color c;
          vector "the corner" corner_;
          vector "the first edge" edge_;
          vector "the second edge" other_;
          whole ~least:1 ~most:Pane.max_count
            "the number of points along an edge" count_;
        ];
    }

let spherical i c position =
  let make intensity color position =
    Light.spherical ~intensity ~color ~position
  in
  Written
    {
      make;
      parameters =
        [ intensity i; color c; vector "the light's position" position ];
    }
