(** The words of the header. *)

open Raylab_source
open Raylab_scene
open Raylab_expression

type t
(** The type for what the settings of a header say. *)

val none : t
(** [none] is what no setting says. *)

type change = (t -> t) Written.t
(** The type for settings that are written: each changes what is known. *)

val required : string list
(** [required] is the settings that no header is without. *)

val scene :
  t -> files:Files.t -> lights:Light.t list -> objects:Object.t list -> Scene.t
(** [scene settings ~files ~lights ~objects] is the scene of these settings,
    the {!required} among them.

    Raises [Invalid_argument] if one of them is missing. *)

(** {1 Words} *)

val im_width : Expression.t -> change
val im_height : Expression.t -> change
val canv_width : Expression.t -> change
val canv_height : Expression.t -> change
val depth : Expression.t -> change
val raydepth : Expression.t -> change
val bcolor : Expression.t -> change
