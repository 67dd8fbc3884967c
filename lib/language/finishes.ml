open Raylab_scene
open Written

let color = color "the surface's colour"

let diffusive c =
  Written { make = Surface.diffusive; parameters = [ color c ] }

let reflective = Written { make = Surface.reflective; parameters = [] }

let glossy sharpness c =
  Written
    {
      make = (fun sharpness c -> Surface.glossy ~sharpness c);
      parameters =
        [ number Non_negative "the sharpness of glossy" sharpness; color c ];
    }

let index i = number Positive "the index of refraction" i

let refractive i c =
  Written
    {
      make = (fun index c -> Surface.refractive ~index c);
      parameters = [ index i; color c ];
    }

let glass i c =
  Written
    {
      make = (fun index c -> Surface.glass ~index c);
      parameters = [ index i; color c ];
    }

let luminous c = Written { make = Surface.luminous; parameters = [ color c ] }
