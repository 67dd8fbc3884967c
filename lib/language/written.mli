(** Words with their parameters, as they are written.

    A word of the language is a function here, such as {!Shapes.sphere}: it
    takes the expressions that stand after it, and says what each is called,
    which rule it obeys, and what is made of them all. The grammar calls it;
    {!Literal} and {!Check} evaluate it. *)

open Raylab_source
open Raylab_geometry
open Raylab_scene
open Raylab_expression

(** What a parameter is. *)
type _ kind =
  | Number : Number.rule -> float kind
  | Whole : { least : int; most : int } -> int kind
  | Vector : Vec3.t kind  (** a point or a vector *)
  | Direction : Vec3.t kind  (** a vector that is not zero *)
  | Pattern : { name : string; name_span : Span.t } -> Surface.t Closed.t kind
      (** a colour, of the point of this name *)
  | Color : Color.t kind  (** its channels not negative *)

type 'a parameter = {
  name : string;  (** as errors call it: ["the radius"] *)
  kind : 'a kind;
  written : Expression.t;
}
(** The type for parameters that are written. *)

(** The type for parameters of which ['make] makes something ['made]. *)
type ('make, 'made) parameters =
  | [] : ('made, 'made) parameters
  | ( :: ) :
      'a parameter * ('make, 'made) parameters
      -> ('a -> 'make, 'made) parameters

(** The type for what is written of something ['made]. *)
type 'made t =
  | Written : {
      parameters : ('make, 'made) parameters;
      make : 'make;
          (** It may raise {!Refused}, and [Invalid_argument] where a number is
              against its rule. *)
    }
      -> 'made t

exception Refused of { message : string; advice : string }
(** Raised by a [make] of parameters each of which is right, where they do not
    fit each other. *)

val refuse : ?advice:string -> string -> 'a
(** [refuse message] raises {!Refused}. *)

(** {1 Parameters} *)

val number : Number.rule -> string -> Expression.t -> float parameter
(** [number rule name e] is a number that obeys [rule]. *)

val whole : least:int -> most:int -> string -> Expression.t -> int parameter
(** [whole ~least ~most name e] is a whole number. *)

val vector : string -> Expression.t -> Vec3.t parameter
(** [vector name e] is a point or a vector. *)

val direction : string -> Expression.t -> Vec3.t parameter
(** [direction name e] is a vector that is not zero. *)

val color : string -> Expression.t -> Color.t parameter
(** [color name e] is a colour. *)

val pattern :
  string * Span.t -> string -> Expression.t -> Surface.t Closed.t parameter
(** [pattern point name e] is a colour that is a function of [point]. *)
