(* The grammar of the scene language.

   Every parameter of a word is an expression with its place. What is written
   in numbers alone is built at once (see Literal). What each state expects is
   told by Expectation. *)

%{
open Raylab_source
open Raylab_expression
open Expression

let span ((start, stop) : Lexing.position * Lexing.position) =
  { Span.start = start.pos_cnum; stop = stop.pos_cnum }

let make desc loc = { desc; span = span loc }

(* Of what is called: the name without its bracket. *)
let name_span ((start, stop) : Lexing.position * Lexing.position) =
  { Span.start = start.pos_cnum; stop = stop.pos_cnum - 1 }

let color_word { Raylab_scene.Color.r; g; b } loc =
  let channel x = make (Number x) loc in
  make (Triple (channel r, channel g, channel b)) loc

(* [[v]] is v where a vector or colour stands. *)
let vector_of e = match e.desc with List [ v ] -> v | _ -> e

let placed thing modifiers loc =
  { Syntax.thing; modifiers = List.rev modifiers; span = span loc }

let setting word loc change =
  Syntax.Setting { word; word_span = span loc; change }

let plain word written loc =
  { Syntax.finish = Plain { word; written }; span = span loc }

let modifier what loc = { Syntax.what; span = span loc }
let change written loc = modifier (Syntax.Change written) loc
%}

%token <float> NUMBER "1"
%token <Raylab_scene.Color.t> COLOR "red"
%token <string> WORD "<unknown word>"
%token <string> NAME "name" CALL "name("
%token <Syntax.included> FILE "\"file\""
%token <Raylab_mesh_file.Model.t> MODEL "\"mesh\""
%token <string> STRING "\"text\""
%token <char> PART ".x"
%token IM_WIDTH "imWidth" IM_HEIGHT "imHeight"
%token CANV_WIDTH "canvWidth" CANV_HEIGHT "canvHeight"
%token DEPTH "depth" BCOLOR "bcolor" AMBIENT "ambient" RAYDEPTH "raydepth"
%token EYE "eye" LOOK_AT "lookAt" UP "up" FOV "fov"
%token SAMPLES "samples" EXPOSURE "exposure" SRGB "srgb"
%token APERTURE "aperture" FOCUS "focus"
%token LIGHTS "lights" DIRECTIONAL "directional" SPHERICAL "spherical"
%token SPOT "spot" AREA "area"
%token OBJECTS "objects" GROUP "group"
%token SPHERE "sphere" PLANE "plane" BOX "box" CYLINDER "cylinder" CONE "cone"
%token TORUS "torus" DISC "disc" TRIANGLE "triangle" QUAD "quad"
%token MESH "mesh" SMOOTH "smooth"
%token UNION "union" INTERSECTION "intersection" DIFFERENCE "difference"
%token DIFFUSIVE "diffusive" REFLECTIVE "reflective" LUMINOUS "luminous"
%token GLOSSY "glossy" REFRACTIVE "refractive" GLASS "glass"
%token MIXED "mixed" CHECKER "checker" VARYING "varying"
%token SCALED "scaled" STRETCHED "stretched" ROTATED "rotated"
%token TRANSLATED "translated" SHADOWLESS "shadowless"
%token UNFADING "unfading"
%token LET "let" FOR "for" IF "if" ELSE "else" END "end" TO "to" BY "by"
%token IN "in" INCLUDE "include"
%token THEN "then" AND "and" OR "or" NOT "not" TRUE "true" FALSE "false"
%token LPAREN "(" RPAREN ")" LBRACKET "[" RBRACKET "]" COMMA "," COLON ":"
%token PLUS "+" MINUS "-" TIMES "*" DIVIDE "/" POWER "^"
%token EQUAL "=" DIFFERENT "<>" LESS "<" LESS_EQUAL "<=" GREATER ">"
%token GREATER_EQUAL ">="
%token EOF

(* A weight belongs to the innermost mix that is open. *)
%nonassoc end_of_mix
%nonassoc NUMBER LPAREN LBRACKET

%nonassoc IN ELSE
%left OR
%left AND
%nonassoc NOT
%nonassoc EQUAL DIFFERENT LESS LESS_EQUAL GREATER GREATER_EQUAL
%left PLUS MINUS
%left TIMES DIVIDE
%nonassoc unary_minus
%right POWER
%left PART

%start <Syntax.t> scene

%%

scene:
  header = header items = body EOF
    { { Syntax.header = List.rev header; items = List.rev items;
        header_end =
          span ($endpos(header), $endpos(header)) } }

header:
  | (* nothing *) { [] }
  | header = header setting = setting { setting :: header }
  | header = header d = definition { Syntax.Header_definition d :: header }
  | header = header i = inclusion { Syntax.Header_include i :: header }

setting:
  | "imWidth" n = atom { setting "imWidth" $loc($1) (Settings.im_width n) }
  | "imHeight" n = atom { setting "imHeight" $loc($1) (Settings.im_height n) }
  | "canvWidth" n = atom
      { setting "canvWidth" $loc($1) (Settings.canv_width n) }
  | "canvHeight" n = atom
      { setting "canvHeight" $loc($1) (Settings.canv_height n) }
  | "depth" n = atom { setting "depth" $loc($1) (Settings.depth n) }
  | "eye" p = vector { setting "eye" $loc($1) (Settings.eye p) }
  | "lookAt" p = vector { setting "lookAt" $loc($1) (Settings.look_at p) }
  | "up" v = vector { setting "up" $loc($1) (Settings.up v) }
  | "fov" n = atom { setting "fov" $loc($1) (Settings.fov n) }
  | "raydepth" n = atom { setting "raydepth" $loc($1) (Settings.raydepth n) }
  | "bcolor" c = color { setting "bcolor" $loc($1) (Settings.bcolor c) }
  | "bcolor" "varying" name = NAME c = color
      { setting "bcolor" $loc($1)
          (Settings.bcolor_varying (name, span $loc(name)) c) }
  | "ambient" c = color { setting "ambient" $loc($1) (Settings.ambient c) }
  | "samples" n = atom { setting "samples" $loc($1) (Settings.samples n) }
  | "exposure" n = atom { setting "exposure" $loc($1) (Settings.exposure n) }
  | "srgb" { setting "srgb" $loc($1) Settings.srgb }
  | "aperture" n = atom { setting "aperture" $loc($1) (Settings.aperture n) }
  | "focus" n = atom { setting "focus" $loc($1) (Settings.focus n) }

(* {1 Items}, the last one first *)

body:
  | (* nothing *) { [] }
  | "lights" items = items { items }
  | "lights" before = items "objects" items = items { items @ before }
  | "objects" items = items { items }
  | first = things { first }
  | first = things "objects" items = items { items @ first }

(* Not to begin with a definition or an include, which belong to the
   header. *)
things:
  | thing = thing { [ thing ] }
  | items = things item = item { item :: items }

items:
  | (* none *) { [] }
  | items = items item = item { item :: items }

item:
  | d = definition { Syntax.Definition d }
  | i = inclusion { Syntax.Include i }
  | thing = thing { thing }

thing:
  | thing = simple_thing { thing }
  | "if" condition = condition yes = items no = otherwise
      { Syntax.If { condition; yes = List.rev yes; no } }

simple_thing:
  | light = light modifiers = modifiers
      { Literal.item (placed (Light light) modifiers $loc(light)) }
  | shape = shape surface = surface modifiers = modifiers
      { Literal.item
          (placed (Shape (shape, surface)) modifiers $loc(shape)) }
  | group = group modifiers = modifiers
      { Syntax.Placed (placed group modifiers $loc(group)) }
  | r = reference modifiers = modifiers
      { Syntax.Placed (placed (Reference r) modifiers $loc(r)) }
  | "for" name = NAME range = range body = items "end"
      { Syntax.For { name; name_span = span $loc(name); range;
              body = List.rev body } }

otherwise:
  | "end" { [] }
  | "else" items = else_items "end" { List.rev items }
  | "else" "if" condition = condition yes = items no = otherwise
      { [ Syntax.If { condition; yes = List.rev yes; no } ] }

(* [else if] goes on with the same [if]. *)
else_items:
  | (* none *) { [] }
  | items = some_else_items { items }

some_else_items:
  | item = else_item { [ item ] }
  | items = some_else_items item = item { item :: items }

else_item:
  | d = definition { Syntax.Definition d }
  | i = inclusion { Syntax.Include i }
  | thing = simple_thing { thing }

condition:
  | "(" e = expr ")" { e }

range:
  | "=" first = atom "to" last = atom { To { first; last; step = None } }
  | "=" first = atom "to" last = atom "by" step = atom
      { To { first; last; step = Some step } }
  | "in" l = bracketed { In l }
  | "in" r = reference { In r }

inclusion:
  | "include" file = FILE { { Syntax.file; span = span $loc(file) } }

definition:
  | "let" name = NAME "=" value = value
      { { Syntax.name; name_span = span $loc(name); parameters = None;
          value } }
  | "let" name = CALL parameters = separated_list(",", parameter) ")" "="
    value = value
      { { Syntax.name; name_span = name_span $loc(name);
          parameters = Some parameters; value } }

parameter:
  | name = NAME { { Function.name; span = span $loc; default = None } }
  | name = NAME ":" e = expr
      { { Function.name; span = span $loc(name); default = Some e } }

value:
  | x = plain { Syntax.Expression x }
  | x = plain y = plain z = plain { Syntax.Expression (bare_triple x y z) }
  | c = COLOR { Syntax.Expression (color_word c $loc) }
  | l = bracketed { Syntax.Expression l }
  | s = STRING { Syntax.Expression (make (Text s) $loc) }
  | r = reference { Syntax.Expression r }
  | r = reference modifiers = some_modifiers
      { Syntax.Thing (placed (Reference r) modifiers $loc(r)) }
  | s = own_surface { Syntax.Surface s }
  | light = light modifiers = modifiers
      { Syntax.Thing (placed (Light light) modifiers $loc(light)) }
  | shape = shape surface = surface modifiers = modifiers
      { Syntax.Thing (placed (Shape (shape, surface)) modifiers $loc(shape)) }
  | group = group modifiers = modifiers
      { Syntax.Thing (placed group modifiers $loc(group)) }

(* {1 Things} *)

light:
  | "directional" intensity = atom color = color direction = vector
      { Lamps.directional intensity color direction }
  | "spherical" intensity = atom color = color position = vector
      { Lamps.spherical intensity color position }
  | "spot" intensity = atom color = color position = vector target = vector
    inner = atom outer = atom
      { Lamps.spot intensity color position target inner outer }
  | "area" intensity = atom color = color corner = vector edge = vector
    other = vector count = atom
      { Lamps.area intensity color corner edge other count }

shape:
  | "sphere" centre = vector radius = atom { Shapes.sphere centre radius }
  | "plane" point = vector normal = vector { Shapes.plane point normal }
  | "box" corner = vector opposite = vector { Shapes.box corner opposite }
  | "cylinder" a = vector b = vector radius = atom
      { Shapes.cylinder a b radius }
  | "cone" a = vector radius_a = atom b = vector radius_b = atom
      { Shapes.cone a radius_a b radius_b }
  | "torus" centre = vector axis = vector ring = atom tube = atom
      { Shapes.torus centre axis ring tube }
  | "disc" centre = vector normal = vector radius = atom
      { Shapes.disc centre normal radius }
  | "triangle" a = vector b = vector c = vector { Shapes.triangle a b c }
  | "quad" corner = vector edge = vector other = vector
      { Shapes.quad corner edge other }
  | "mesh" model = MODEL { Shapes.mesh model ~is_smooth:false }
  | "mesh" model = MODEL "smooth" { Shapes.mesh model ~is_smooth:true }

group:
  | g = grouping items = items "end" { Syntax.Group (g, List.rev items) }

grouping:
  | "group" { Thing.Together }
  | "union" { Thing.Solid Union }
  | "intersection" { Thing.Solid Intersection }
  | "difference" { Thing.Solid Difference }

modifiers:
  | (* none *) { [] }
  | modifiers = some_modifiers { modifiers }

some_modifiers:
  | modifier = modifier { [ modifier ] }
  | modifiers = some_modifiers modifier = modifier { modifier :: modifiers }

modifier:
  | "scaled" factor = atom { change (Modifiers.scaled factor) $loc($1) }
  | "stretched" factors = vector
      { change (Modifiers.stretched factors) $loc($1) }
  | "rotated" axis = vector angle = atom
      { change (Modifiers.rotated axis angle) $loc($1) }
  | "translated" way = vector { change (Modifiers.translated way) $loc($1) }
  | "shadowless" { modifier Syntax.Shadowless $loc($1) }
  | "unfading" { modifier Syntax.Unfading $loc($1) }

(* {1 Surfaces} *)

surface:
  | s = own_surface { s }
  | r = reference { { Syntax.finish = Chosen r; span = span $loc } }
  | "(" e = expr ")" { { Syntax.finish = Chosen e; span = span $loc } }

own_surface:
  | "diffusive" c = color { plain "diffusive" (Finishes.diffusive c) $loc($1) }
  | "reflective" { plain "reflective" Finishes.reflective $loc($1) }
  | "luminous" c = color { plain "luminous" (Finishes.luminous c) $loc($1) }
  | "glossy" sharpness = atom c = color
      { plain "glossy" (Finishes.glossy sharpness c) $loc($1) }
  | "refractive" index = atom c = color
      { plain "refractive" (Finishes.refractive index c) $loc($1) }
  | "glass" index = atom c = color { plain "glass" (Finishes.glass index c) $loc($1) }
  | "mixed" parts = parts
      { { Syntax.finish = Mixed parts; span = span $loc($1) } }
  | "checker" size = atom even = surface odd = surface
      { { Syntax.finish = Checker (size, even, odd);
          span = span $loc($1) } }
  | "varying" name = NAME body = surface
      { { Syntax.finish =
            Varying { name; name_span = span $loc(name); body };
          span = span $loc($1) } }

parts:
  | weight = weight surface = surface %prec end_of_mix { [ (weight, surface) ] }
  | weight = weight surface = surface parts = parts
      { (weight, surface) :: parts }

weight:
  | x = plain { Syntax.Factor x }
  | l = bracketed { Syntax.Tint (vector_of l) }

(* {1 Numbers, vectors, colours} *)

(* One number; brackets hold an expression. *)
plain:
  | n = NUMBER { make (Number n) $loc }
  | "(" e = expr ")" { e }

atom:
  | x = plain { x }
  | r = reference { r }

vector:
  | x = atom y = atom z = atom { bare_triple x y z }
  | l = bracketed { vector_of l }

color:
  | r = plain g = plain b = plain { bare_triple r g b }
  | c = COLOR { color_word c $loc }
  | r = reference { r }
  | l = bracketed { vector_of l }

reference:
  | name = NAME { make (Name name) $loc }
  | name = CALL arguments = separated_list(",", argument) ")"
      { make (Call { name; name_span = name_span $loc(name); arguments })
          $loc }

argument:
  | value = expr { { label = None; value } }
  | label = NAME ":" value = expr
      { { label = Some (label, span $loc(label)); value } }

(* {1 Expressions} *)

bracketed:
  | "[" elements = separated_list(",", expr) "]" { make (List elements) $loc }
  | "[" "for" name = NAME range = expr_range ":" body = expr "]"
      { make
          (Series { name; name_span = span $loc(name); range; body })
          $loc }

expr_range:
  | "=" first = expr "to" last = expr { To { first; last; step = None } }
  | "=" first = expr "to" last = expr "by" step = expr
      { To { first; last; step = Some step } }
  | "in" e = expr { In e }

expr:
  | n = NUMBER { make (Number n) $loc }
  | s = STRING { make (Text s) $loc }
  | "true" { make (Truth true) $loc }
  | "false" { make (Truth false) $loc }
  | r = reference { r }
  | l = bracketed { l }
  | "(" e = expr ")" { e }
  | e = expr letter = PART { make (Part (e, letter)) $loc }
  | "-" e = expr %prec unary_minus { make (Negative e) $loc }
  | "not" e = expr { make (Not e) $loc }
  | a = expr o = operator b = expr { make (Binary (o, a, b)) $loc }
  | "if" c = expr "then" a = expr "else" b = expr { make (If (c, a, b)) $loc }
  | "let" name = NAME "=" value = expr "in" body = expr
      { make
          (Expression.Let { name; name_span = span $loc(name); value; body })
          $loc }

%inline operator:
  | "+" { Add }
  | "-" { Subtract }
  | "*" { Multiply }
  | "/" { Divide }
  | "^" { Power }
  | "=" { Equal }
  | "<>" { Different }
  | "<" { Less }
  | "<=" { Less_or_equal }
  | ">" { Greater }
  | ">=" { Greater_or_equal }
  | "and" { And }
  | "or" { Or }
