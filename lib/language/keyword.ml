open Raylab_scene

type role =
  | Setting
  | Heading
  | Light
  | Shape
  | Surface
  | Grouping
  | Modifier
  | Structure
  | Operator
  | Color

type parameter = { noun : string; expected : string }

type t = {
  word : string;
  token : Parser.token;
  symbol : string;
  role : role;
  parameters : parameter list;
  doc : string;
}

let row role word token symbol parameters doc =
  let parameter (noun, expected) = { noun; expected } in
  { word; token; symbol; role; doc;
    parameters = List.map parameter parameters }
[@@ocamlformat "disable"]

let settings : t list =
  let row = row Setting in
  let background =
    ("colour", "the background colour after bcolor: three numbers (red green \
                blue) or a name such\nas red or white")
  in
  [
    row "imWidth" IM_WIDTH "IM_WIDTH"
      [ ("number", "the width of the picture in pixels after imWidth, such as \
                    640") ]
      "the width of the picture in pixels";
    row "imHeight" IM_HEIGHT "IM_HEIGHT"
      [ ("number", "the height of the picture in pixels after imHeight, such \
                    as 480") ]
      "the height of the picture in pixels";
    row "canvWidth" CANV_WIDTH "CANV_WIDTH"
      [ ("number", "the width of the canvas after canvWidth, such as 4") ]
      "the width of the canvas";
    row "canvHeight" CANV_HEIGHT "CANV_HEIGHT"
      [ ("number", "the height of the canvas after canvHeight, such as 3") ]
      "the height of the canvas";
    row "depth" DEPTH "DEPTH"
      [ ("number", "the distance from the eye to the canvas after depth, such \
                    as 4") ]
      "the distance from the eye to the canvas";
    row "eye" EYE "EYE"
      [ ("number", "the point at which the eye is after eye: three numbers, x \
                    y z") ]
      "the point from which one looks";
    row "lookAt" LOOK_AT "LOOK_AT"
      [ ("number", "the point in the middle of the picture after lookAt: three \
                    numbers,\nx y z") ]
      "the point at which one looks";
    row "up" UP "UP"
      [ ("number", "the direction that is up in the picture after up: three \
                    numbers,\nsuch as 0 1 0") ]
      "the direction that is up in the picture";
    row "fov" FOV "FOV"
      [ ("number", "the horizontal angle of view in degrees after fov, such as \
                    60") ]
      "the horizontal angle of view, instead of canvas and depth";
    row "bcolor" BCOLOR "BCOLOR" [ background ] "the colour of the background";
    row "bgcolor" BCOLOR "BCOLOR" [ background ] "the same as bcolor";
    row "ambient" AMBIENT "AMBIENT"
      [ ("colour", "the colour of the ambient light after ambient: three \
                    numbers (red green blue)\nor a name such as grey") ]
      "light that is the same everywhere";
    row "raydepth" RAYDEPTH "RAYDEPTH"
      [ ("number", "the number of rays in a chain after raydepth, such as 4") ]
      "how many rays are in a chain at most";
    row "samples" SAMPLES "SAMPLES"
      [ ("number", "the number of samples of a pixel after samples, such as \
                    16") ]
      "how many samples a pixel takes at most";
    row "exposure" EXPOSURE "EXPOSURE"
      [ ("number", "the factor of all brightness after exposure, such as 1.5") ]
      "how much brighter all is shown";
    row "srgb" SRGB "SRGB" []
      "shows colours by the sRGB curve, as screens expect";
    row "aperture" APERTURE "APERTURE"
      [ ("number", "the radius of the lens after aperture, such as 0.1") ]
      "the radius of the lens";
    row "focus" FOCUS "FOCUS"
      [ ("number", "the distance that is sharp after focus, such as 5") ]
      "the distance from the eye at which all is sharp";
  ]
[@@ocamlformat "disable"]

let lights : t list =
  let row = row Light in
  let color =
    ("colour", "the colour of the light: three numbers (red green blue) or a \
                name\nsuch as red or white")
  in
  [
    row "directional" DIRECTIONAL "DIRECTIONAL"
      [ ("number", "the intensity of the light: directional INTENSITY COLOUR \
                    DIRECTION"); color;
        ("number", "the direction in which the light travels: three numbers, \
                    x y z") ]
      "light that comes from far away";
    row "spherical" SPHERICAL "SPHERICAL"
      [ ("number", "the intensity of the light: spherical INTENSITY COLOUR \
                    POINT"); color;
        ("number", "the point from which the light shines: three numbers, x y \
                    z") ]
      "light that shines from a point";
    row "spot" SPOT "SPOT"
      [ ("number", "the intensity of the light: spot INTENSITY COLOUR POINT \
                    TARGET INNER OUTER"); color;
        ("number", "the point from which the light shines: three numbers, x y \
                    z");
        ("number", "the target, the point at which the light shines: three \
                    numbers, x y z");
        ("number", "the inner angle in degrees, from the axis, within which \
                    the light is full");
        ("number", "the outer angle in degrees, from the axis, beyond which \
                    there is no light") ]
      "light that shines from a point into a cone";
    row "area" AREA "AREA"
      [ ("number", "the intensity of the light: area INTENSITY COLOUR CORNER \
                    EDGE EDGE N"); color;
        ("number", "a corner of the lit parallelogram: three numbers, x y z");
        ("number", "its first edge, from the corner: three numbers, x y z");
        ("number", "its second edge, from the corner: three numbers, x y z");
        ("number", "the number of points along each edge, such as 4") ]
      "light that shines from a parallelogram: soft shadows";
  ]
[@@ocamlformat "disable"]

let shapes : t list =
  let row = row Shape in
  [
    row "sphere" SPHERE "SPHERE"
      [ ("number", "the centre of the sphere: sphere CENTRE RADIUS, the centre \
                    being\nthree numbers, x y z");
        ("number", "the radius of the sphere after its centre") ]
      "a ball";
    row "plane" PLANE "PLANE"
      [ ("number", "a point of the plane: plane POINT NORMAL, each three \
                    numbers, x y z");
        ("number", "the normal of the plane: three numbers, x y z") ]
      "a plane without end";
    row "box" BOX "BOX"
      [ ("number", "a corner of the box: box CORNER CORNER, each three \
                    numbers, x y z");
        ("number", "the opposite corner of the box: three numbers, x y z") ]
      "a box with sides along the axes";
    row "cylinder" CYLINDER "CYLINDER"
      [ ("number", "the first end of the cylinder: cylinder POINT POINT RADIUS, \
                    each point\nbeing three numbers, x y z");
        ("number", "the second end of the cylinder: three numbers, x y z");
        ("number", "the radius of the cylinder after its two ends") ]
      "a cylinder, closed at both ends";
    row "cone" CONE "CONE"
      [ ("number", "the first end of the cone: cone POINT RADIUS POINT RADIUS, \
                    each point being\nthree numbers, x y z");
        ("number", "the radius of the cone at its first end");
        ("number", "the second end of the cone: three numbers, x y z");
        ("number", "the radius of the cone at its second end") ]
      "a cone, closed at both ends";
    row "torus" TORUS "TORUS"
      [ ("number", "the centre of the torus: torus CENTRE AXIS RADIUS \
                    RADIUS_OF_TUBE, the centre\nand the axis being three \
                    numbers, x y z");
        ("number", "the axis of the torus: three numbers, x y z");
        ("number", "the radius of the torus, from its centre to the middle of \
                    its tube");
        ("number", "the radius of the tube after that of the ring") ]
      "a ring";
    row "disc" DISC "DISC"
      [ ("number", "the centre of the disc: disc CENTRE NORMAL RADIUS, the \
                    centre being three\nnumbers, x y z");
        ("number", "the normal of the disc: three numbers, x y z");
        ("number", "the radius of the disc after its normal") ]
      "a flat round piece of a plane";
    row "triangle" TRIANGLE "TRIANGLE"
      [ ("number", "the first corner of the triangle: triangle A B C, each \
                    three numbers, x y z");
        ("number", "the second corner of the triangle: three numbers, x y z");
        ("number", "the third corner of the triangle: three numbers, x y z") ]
      "a triangle";
    row "quad" QUAD "QUAD"
      [ ("number", "a corner of the quad: quad CORNER EDGE EDGE, each three \
                    numbers, x y z");
        ("number", "the first edge of the quad, from its corner: three \
                    numbers, x y z");
        ("number", "the second edge of the quad, from its corner: three \
                    numbers, x y z") ]
      "a parallelogram";
    row "mesh" MESH "MESH"
      [ ("file name", "the name of a file in quotes after mesh, such as \
                       \"bunny.ply\"");
        ("surface", "smooth, or a surface: diffusive, reflective, luminous or \
                     mixed") ]
      "the triangles in a file: OBJ, PLY or STL";
  ]
[@@ocamlformat "disable"]

let surfaces : t list =
  let row = row Surface in
  let color word =
    [ ("colour", Printf.sprintf "the colour after %s: three numbers (red green \
                                 blue) or a\nname such as red or white" word) ]
  in
  [
    row "diffusive" DIFFUSIVE "DIFFUSIVE" (color "diffusive")
      "returns light to all sides";
    row "reflective" REFLECTIVE "REFLECTIVE" [] "a perfect mirror";
    row "luminous" LUMINOUS "LUMINOUS" (color "luminous") "glows";
    row "glossy" GLOSSY "GLOSSY"
      (("number", "the sharpness after glossy, such as 20: glossy SHARPNESS \
                   COLOUR") :: color "the sharpness")
      "shines where it mirrors a light";
    row "refractive" REFRACTIVE "REFRACTIVE"
      (("number", "the index of refraction after refractive, such as 1.33: \
                   refractive INDEX COLOUR") :: color "the index")
      "lets what is behind it through, bent";
    row "glass" GLASS "GLASS"
      (("number", "the index of refraction after glass, such as 1.5: glass \
                   INDEX COLOUR") :: color "the index")
      "mirrors and lets through, as glass does";
    row "mixed" MIXED "MIXED"
      [ ("number", "the weight of the first part of the mix, a number or a \
                    colour in [ ]:\nmixed WEIGHT SURFACE WEIGHT SURFACE ...") ]
      "a sum of surfaces";
    row "checker" CHECKER "CHECKER"
      [ ("number", "the size of the cubes of the checker, such as 1:\n\
                    checker SIZE SURFACE SURFACE");
        ("surface", "the first surface of the checker: checker SIZE SURFACE \
                     SURFACE");
        ("surface", "the second surface of the checker: checker SIZE SURFACE \
                     SURFACE") ]
      "cubes of two surfaces in turn";
    row "varying" VARYING "VARYING"
      [ ("name", "a name for the point after varying:\n\
                  varying NAME SURFACE");
        ("surface", "the surface after the name of the point: varying NAME \
                     SURFACE") ]
      "a surface that is a function of the point";
  ]
[@@ocamlformat "disable"]

let modifiers : t list =
  let row = row Modifier in
  [
    row "scaled" SCALED "SCALED"
      [ ("number", "the factor after scaled, such as 2") ]
      "larger or smaller, seen from the origin";
    row "stretched" STRETCHED "STRETCHED"
      [ ("number", "three factors after stretched, along x, y and z") ]
      "larger or smaller along each axis";
    row "rotated" ROTATED "ROTATED"
      [ ("number", "the axis after rotated: rotated AXIS ANGLE, the axis being \
                    three\nnumbers, x y z");
        ("number", "the angle in degrees after the axis") ]
      "turned around an axis through the origin";
    row "translated" TRANSLATED "TRANSLATED"
      [ ("number", "the way after translated: three numbers, x y z") ]
      "moved";
    row "shadowless" SHADOWLESS "SHADOWLESS" [] "casts no shadow";
    row "unfading" UNFADING "UNFADING" []
      "a light that is as strong far away as near";
    row "smooth" SMOOTH "SMOOTH" [] "after the file of a mesh: shaded as round";
  ]
[@@ocamlformat "disable"]

let name_after what =
  ("name", Printf.sprintf "a name after %s: letters, digits and _, not one of \
                           let, for, if, else, end, to,\nby, in and include"
             what)
[@@ocamlformat "disable"]

let structure : t list =
  let row = row Structure in
  [
    row "let" LET "LET" [ name_after "let" ]
      "names a value, a surface, a light, an object or a function";
    row "for" FOR "FOR" [ name_after "for" ]
      "repeats items for each value of a name";
    row "if" IF "IF"
      [ ("condition", "a condition in brackets after if, such as (n > 0)") ]
      "has items only where a condition is true";
    row "else" ELSE "ELSE" [] "the items where it is not";
    row "end" END "END" [] "ends for, if and groupings";
    row "to" TO "TO" [ ("number", "the last value of the loop after to") ]
      "before the last value of a loop";
    row "by" BY "BY" [ ("number", "the step of the loop after by") ]
      "before the step of a loop";
    row "in" IN "IN" [ ("list", "a list after in: [ ... ] or a name") ]
      "before the list of a loop";
    row "include" INCLUDE "INCLUDE"
      [ ("file name", "the name of a file in quotes after include, such as \
                       \"wood.scene\"") ]
      "puts in its place what another file says";
  ]
[@@ocamlformat "disable"]

let others : t list =
  [
    row Heading "lights" LIGHTS "LIGHTS" [] "may stand before the lights";
    row Heading "objects" OBJECTS "OBJECTS" [] "may stand before the objects";
    row Grouping "group" GROUP "GROUP" [] "puts items together";
    row Grouping "union" UNION "UNION" [] "what is in one of its parts";
    row Grouping "intersection" INTERSECTION "INTERSECTION" []
      "what is in all of its parts";
    row Grouping "difference" DIFFERENCE "DIFFERENCE" []
      "its first part without the others";
  ]

let operators : t list =
  let row (word, token) =
    row Operator word token (String.uppercase_ascii word) [] ""
  in
  List.map row
    [ ("then", Parser.THEN); ("and", AND); ("or", OR); ("not", NOT);
      ("true", TRUE); ("false", FALSE) ]
[@@ocamlformat "disable"]

let colors : t list =
  let color (name, c) = row Color name (Parser.COLOR c) "COLOR" [] "" in
  List.map color Color.names

let table =
  settings @ others @ lights @ shapes @ surfaces @ modifiers @ structure
  @ operators @ colors

let words role =
  List.filter_map
    (fun row -> if row.role = role then Some row.word else None)
    table

let all =
  List.filter_map
    (fun { word; token; role; _ } ->
      if role = Operator then None else Some (word, token))
    table

let rows is_it =
  let named row = (String.lowercase_ascii row.word, row) in
  let found =
    Hashtbl.of_seq (List.to_seq (List.map named (List.filter is_it table)))
  in
  fun word -> Hashtbl.find_opt found (String.lowercase_ascii word)

let find = rows (fun { role; _ } -> role <> Operator)

let find_reserved_inside =
  rows (fun { role; _ } -> role = Structure || role = Operator)

let token_of row = row.token
let token word = Option.map token_of (find word)
let reserved_inside word = Option.map token_of (find_reserved_inside word)
let of_symbol symbol = List.find_opt (fun row -> row.symbol = symbol) table
let nearest = Raylab_expression.Nearest.find
