open Raylab_source
open Raylab_geometry
open Raylab_scene
open Raylab_expression

type _ kind =
  | Number : Number.rule -> float kind
  | Whole : { least : int; most : int } -> int kind
  | Vector : Vec3.t kind
  | Direction : Vec3.t kind
  | Pattern : { name : string; name_span : Span.t } -> Surface.t Closed.t kind
  | Color : Color.t kind

type 'a parameter = { name : string; kind : 'a kind; written : Expression.t }

type ('make, 'made) parameters =
  | [] : ('made, 'made) parameters
  | ( :: ) :
      'a parameter * ('make, 'made) parameters
      -> ('a -> 'make, 'made) parameters

type 'made t =
  | Written : {
      parameters : ('make, 'made) parameters;
      make : 'make;
    }
      -> 'made t

exception Refused of { message : string; advice : string }

let refuse ?(advice = "") message = raise (Refused { message; advice })
let number rule name written = { name; kind = Number rule; written }

let whole ~least ~most name written =
  { name; kind = Whole { least; most }; written }

let vector name written = { name; kind = Vector; written }
let direction name written = { name; kind = Direction; written }
let color name written = { name; kind = Color; written }

let pattern (point, name_span) name written =
  { name; kind = Pattern { name = point; name_span }; written }
