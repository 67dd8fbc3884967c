open Raylab_scene
open Written

let color = color "the surface's colour"

let diffusive c =
  Written { make = Surface.diffusive; parameters = [ color c ] }

let reflective = Written { make = Surface.reflective; parameters = [] }
let luminous c = Written { make = Surface.luminous; parameters = [ color c ] }
