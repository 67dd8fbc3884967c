(** Scenes as they are written: parsed, but nothing evaluated or checked yet.

    What is written in numbers alone and is as it should be is built at once: a
    scene may have millions of such objects. Of all else every part is an
    expression and knows its place. *)

open Raylab_source
open Raylab_geometry
open Raylab_expression
open Raylab_scene

type surface = { finish : finish; span : Span.t  (** of its first word *) }

and finish =
  | Plain of { word : string; written : Surface.t Written.t }
  | Mixed of (weight * surface) list
  | Checker of Expression.t * surface * surface
  | Varying of { name : string; name_span : Span.t; body : surface }
  | Chosen of Expression.t  (** a name, or what stands in brackets *)

and weight =
  | Factor of Expression.t
  | Tint of Expression.t  (** a colour, in square brackets *)

type what = Change of Change.modifier Written.t | Shadowless | Unfading
type modifier = { what : what; span : Span.t  (** of its first word *) }

type item =
  | Ready_object of Object.t
  | Ready_light of Light.t
  | Placed of placed
  | Definition of definition
  | For of {
      name : string;
      name_span : Span.t;
      range : Expression.range;
      body : item list;
    }
  | If of { condition : Expression.t; yes : item list; no : item list }
  | Include of inclusion

and placed = {
  thing : thing;
  modifiers : modifier list;  (** in the order in which they are written *)
  span : Span.t;  (** of its first word *)
}

and thing =
  | Light of Light.t Written.t
  | Shape of Shape.t Written.t * surface
  | Group of Thing.grouping * item list
  | Reference of Expression.t

and definition = {
  name : string;
  name_span : Span.t;
  parameters : Function.parameter list option;  (** [None]: no function *)
  value : value;
}

and value = Expression of Expression.t | Surface of surface | Thing of placed
and inclusion = { file : included; span : Span.t  (** of its name *) }

and included = {
  base : int;  (** where the file starts in the space of offsets *)
  names : string list;  (** that it defines, in lower case *)
  syntax : t;
}
(** A file that is included. However often it is, there is one of it. *)

and setting = { word : string; word_span : Span.t; change : Settings.change }
(** A setting of the header. *)

and header_item =
  | Setting of setting
  | Header_definition of definition
  | Header_include of inclusion

and t = {
  header : header_item list;
  header_end : Span.t;  (** the empty span after the last setting *)
  items : item list;
}
(** The type for parsed scenes. *)
