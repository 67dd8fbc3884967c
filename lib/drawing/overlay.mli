(** The path of a pixel's rays as the camera sees it, over the picture.

    Nothing here depends on how large the picture is shown: that is for
    {!draw}. *)

open Raylab_scene

type line = {
  kind : Path.kind;
  tint : Color.t;  (** of the light that comes along a shadow ray *)
  ends : Drawing.point * Drawing.point;
}
(** The type for rays as they are seen. *)

type t = {
  lines : line list;
      (** in the order in which rays were cast, but for the primary ray, which
          is seen as a point: the pixel itself *)
  hits : Drawing.point list;  (** where rays of the chain hit *)
  blocks : Drawing.point list;  (** where shadow rays end in an object *)
}
(** The type for overlays. Places are in pixels of the picture, and may be
    outside it. *)

val make : Camera.t -> first_row:int -> Path.t -> t
(** [make camera ~first_row path] is [path] as [camera] sees it, in the picture
    whose top row is [first_row] of all. Of more than 400 rays only the first
    are there. *)

val kinds : t -> Path.kind list
(** [kinds overlay] is the kinds of its lines, each once. *)

val draw :
  place:(Drawing.point -> Drawing.point) ->
  Rectangle.t ->
  pixel:int * int ->
  t ->
  Drawing.t
(** [draw ~place window ~pixel overlay] is the part of [overlay] that is in
    [window], with a ring around [pixel], whose path it is. [place p] is where
    the window shows the place [p] of the picture. Lines are equally thick at
    any scale. *)
