(* The grammar of the scene language.

   Numbers are checked later (see Check), so that one run reports every number
   that is out of range. *)

%{
open Raylab_geometry
open Raylab_scene

let span (start : Lexing.position) (stop : Lexing.position) =
  Span.make ~start:start.pos_cnum ~stop:stop.pos_cnum

let start (place : Lexing.position) = place.pos_cnum
let line (place : Lexing.position) = place.pos_lnum
let located value start stop = { Syntax.value; span = span start stop }
%}

%token <float> NUMBER "1"
%token <Raylab_scene.Color.t> COLOR "red"
%token <string> WORD "<unknown word>"
%token IM_WIDTH "imWidth" IM_HEIGHT "imHeight"
%token CANV_WIDTH "canvWidth" CANV_HEIGHT "canvHeight"
%token DEPTH "depth" BCOLOR "bcolor" RAYDEPTH "raydepth"
%token LIGHTS "lights" DIRECTIONAL "directional" SPHERICAL "spherical"
%token OBJECTS "objects" SPHERE "sphere" PLANE "plane"
%token DIFFUSIVE "diffusive" REFLECTIVE "reflective" LUMINOUS "luminous"
%token MIXED "mixed"
%token EOF

(* A weight belongs to the innermost mix that is open. *)
%nonassoc end_of_mix
%nonassoc NUMBER

%start <Syntax.t> scene

%%

scene:
  header = header lights = lights objects = objects EOF
    { { Syntax.header = List.rev header; lights = List.rev lights;
        objects = List.rev objects;
        header_end = span $endpos(header) $endpos(header) } }

header:
  | (* nothing *) { [] }
  | header = header setting = setting { setting :: header }

(* each with the span of its keyword *)
setting:
  | "imWidth" n = number
      { (span $startpos $endpos($1),
         Syntax.Image_width (located n $startpos(n) $endpos(n))) }
  | "imHeight" n = number
      { (span $startpos $endpos($1),
         Syntax.Image_height (located n $startpos(n) $endpos(n))) }
  | "canvWidth" n = number
      { (span $startpos $endpos($1),
         Syntax.Canvas_width (located n $startpos(n) $endpos(n))) }
  | "canvHeight" n = number
      { (span $startpos $endpos($1),
         Syntax.Canvas_height (located n $startpos(n) $endpos(n))) }
  | "depth" n = number
      { (span $startpos $endpos($1),
         Syntax.Depth (located n $startpos(n) $endpos(n))) }
  | "raydepth" n = number
      { (span $startpos $endpos($1),
         Syntax.Ray_depth (located n $startpos(n) $endpos(n))) }
  | "bcolor" c = color
      { (span $startpos $endpos($1), Syntax.Background c) }

lights:
  | (* none *) { [] }
  | "lights" lights = some_lights { lights }

some_lights:
  | (* none *) { [] }
  | lights = some_lights light = light { light :: lights }

light:
  | "directional" intensity = number color = color direction = vector
      { { Syntax.source = Directional direction; intensity; color;
          start = start $startpos; line = line $startpos } }
  | "spherical" intensity = number color = color position = vector
      { { Syntax.source = Spherical position; intensity; color;
          start = start $startpos; line = line $startpos } }

objects:
  | (* none *) { [] }
  | "objects" { [] }
  | objects = objects shape = shape surface = surface
      { { Syntax.shape; surface; start = start $startpos(shape);
          line = line $startpos(shape) }
        :: objects }

shape:
  | "sphere" centre = vector radius = number
    { Syntax.Sphere { centre; radius } }
  | "plane" point = vector normal = vector { Syntax.Plane { point; normal } }

surface:
  | "diffusive" c = color { Syntax.Diffusive c }
  | "reflective" { Syntax.Reflective }
  | "luminous" c = color { Syntax.Luminous c }
  | "mixed" parts = parts { Syntax.Mixed parts }

parts:
  | weight = number surface = surface %prec end_of_mix { [ (weight, surface) ] }
  | weight = number surface = surface parts = parts
      { (weight, surface) :: parts }

number:
  | n = NUMBER { n }

vector:
  | x = NUMBER y = NUMBER z = NUMBER { Vec3.make x y z }

color:
  | r = NUMBER g = NUMBER b = NUMBER { Color.make r g b }
  | c = COLOR { c }
