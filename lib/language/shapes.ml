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
