open Raylab_geometry
open Raylab_expression
open Written

let scaled factor =
  let make k = Change.Scaled k in
  Written { make; parameters = [ number Positive "the factor" factor ] }

let stretched factors =
  let make ({ Vec3.x; y; z } as factors) =
    if x = 0. || y = 0. || z = 0. then
      refuse "a factor of stretched must not be 0"
        ~advice:"a factor of 1 leaves a direction as it is"
    else Change.Stretched factors
  in
  Written { make; parameters = [ vector "the factors" factors ] }

let rotated axis angle =
  let make axis angle =
    let axis = Direction.of_vec3_exn axis in
    Change.Rotated
      { axis; angle; sin = Degrees.sin angle; cos = Degrees.cos angle }
  in
  Written
    {
      make;
      parameters =
        [ direction "the axis" axis; number Finite "the angle" angle ];
    }

let translated way =
  let make way = Change.Translated way in
  Written { make; parameters = [ vector "the way" way ] }
