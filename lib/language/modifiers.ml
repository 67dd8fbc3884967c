open Raylab_geometry
open Raylab_expression
open Written

let scaled factor =
  Written
    {
      make = Similarity.scaled;
      parameters = [ number Positive "the factor" factor ];
    }

let stretched factors =
  let make _ =
    refuse "shapes cannot be stretched yet"
      ~advice:"scaled changes the size in all directions alike"
  in
  Written { make; parameters = [ vector "the factors" factors ] }

let rotated axis angle =
  let make axis angle =
    Similarity.rotated
      ~axis:(Direction.of_vec3_exn axis)
      ~sin:(Degrees.sin angle) ~cos:(Degrees.cos angle)
  in
  Written
    {
      make;
      parameters =
        [ direction "the axis" axis; number Finite "the angle" angle ];
    }

let translated way =
  Written
    { make = Similarity.translated; parameters = [ vector "the way" way ] }
