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
