let looks_so { Color.r; g; b } =
  let is_byte x = Float.is_integer x && x <= 255. in
  is_byte r && is_byte g && is_byte b && Float.max r (Float.max g b) >= 100.

let numbers format { Color.r; g; b } =
  String.concat " " (List.map (Format.asprintf format) [ r; g; b ])

type named = { name : string; color : Color.t; origin : Origin.t }

let sentence { name; color; origin } =
  let text =
    Printf.sprintf
      "%s has the colour %s, which looks like 0 to 255; from 0 to 1 it is %s"
      name (numbers "%g" color)
      (numbers "%.3g" (Color.scale (1. /. 255.) color))
  in
  { Warning.text; about = [ origin ] }

let of_light k (light : Light.t) =
  let { Light.color; origin; _ } = light in
  if looks_so color then
    Some { name = Printf.sprintf "light %d" (k + 1); color; origin }
  else None

(* There may be millions of objects: nothing is made of those that are right. *)
let of_objects objects =
  let add_object (number, found) (o : Object.t) =
    let add_color found color =
      if looks_so color then
        { name = Warning.name number o; color; origin = o.origin } :: found
      else found
    in
    let add_surface found surface =
      List.fold_left add_color found (Surface.colors surface)
    in
    (number + 1, List.fold_left add_surface found (Object.surfaces o))
  in
  List.rev (snd (List.fold_left add_object (1, []) objects))

let of_background background =
  Background.colors background
  |> List.filter looks_so
  |> List.map (fun color ->
         { name = "the background"; color; origin = Origin.Unknown })

let of_setting name color =
  if looks_so color then [ { name; color; origin = Origin.Unknown } ] else []

let warnings ~background ~ambient lights objects =
  of_background background
  @ of_setting "the ambient light" ambient
  @ List.filter_map Fun.id (List.mapi of_light lights)
  @ of_objects objects
  |> Warning.few "colour" sentence
