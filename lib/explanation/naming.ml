open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let place = function
  | None -> ""
  | Some place -> ", " ^ Provenance.to_string place

let name (o : Object.t) number = Shape.name o.shape ^ " " ^ number

let at_place name = function
  | None -> name
  | Some place -> Printf.sprintf "%s (%s)" name (Provenance.to_string place)

let with_part shape part name =
  match Shape.part shape part with
  | None -> name
  | Some word ->
      (* a file's name may be in it *)
      Printf.sprintf "the %s of %s" (Raylab_source.Printable.text word) name

let number_of number { Explain.index; _ } = Printf.sprintf "%d.%d" number index

let by_number ?primitive number o place =
  let whole = at_place (name o (string_of_int number)) place in
  match primitive with
  | None -> whole
  | Some ({ Explain.object_; place; is_taken_away; _ } as primitive) ->
      let part = at_place (name object_ (number_of number primitive)) place in
      if is_taken_away then
        Printf.sprintf "the inside of %s, cut by %s" whole part
      else Printf.sprintf "%s of %s" part whole

(* {1 Surfaces} *)

type paint = { word : string; part : float }

let add_paint weight paints color =
  let word = Color_word.of_color color in
  let is_same paint = paint.word = word in
  if weight = 0. then paints
  else if List.exists is_same paints then
    let grow paint =
      if is_same paint then
        { paint with part = Saturate.limit (paint.part +. weight) }
      else paint
    in
    List.map grow paints
  else { word; part = weight } :: paints

(* A weight as a number and the colour that it gives to what it weighs. *)
let tint weight =
  let part = Color.largest weight in
  if Color.equal weight (Color.make part part part) then (part, Color.white)
  else
    let scale = Saturate.limit (1. /. part) in
    (part, Saturate.color (Color.scale scale weight))

(* The colours that a surface is painted with, in the order in which they are
   written, one for each word. The last one is the first of the list. *)
let rec add_paints weight paints = function
  | Surface.Mixed { parts; _ } ->
      let add paints (part, surface) =
        let weight = Saturate.color (Color.multiply weight part) in
        add_paints weight paints surface
      in
      List.fold_left add paints parts
  | simple ->
      let part, tint = tint weight in
      let add color = add_paint part paints (Color.multiply tint color) in
      Option.fold ~none:paints ~some:add (Surface.paint simple)

let paints surface = List.rev (add_paints Color.white [] surface)

let rec starts_with_mirror = function
  | Surface.Mixed { parts = (_, first) :: _; _ } -> starts_with_mirror first
  | surface -> Color.largest (Surface.lobes surface).mirror > 0.

let glow emission =
  match Color_word.of_glow emission with
  | true, word -> "a faint " ^ word ^ " glow"
  | false, word -> Words.a word ^ " glow"

(* A word after that for its colour, unless it has none. *)
let colored part color word =
  let scale = Saturate.limit (1. /. part) in
  match Color_word.of_color (Saturate.color (Color.scale scale color)) with
  | "white" -> word
  | color -> color ^ " " ^ word

(* What lets light through, one for each refraction of glass and of another
   kind. *)
let clear { Lobes.refractions; _ } =
  let add { Lobes.plain; fresnel; glass; _ } =
    let of_glass =
      match Color.largest fresnel with
      | 0. -> []
      | part -> [ { word = colored part glass "glass"; part } ]
    and of_plain =
      match Color.largest plain with
      | 0. -> []
      | part -> [ { word = colored part plain "transparent"; part } ]
    in
    of_glass @ of_plain
  in
  List.concat_map add refractions

let mix surface paints ({ Lobes.emission; mirror; _ } as lobes) =
  let in_percent =
    List.map (fun { word; part } -> Words.percent part ^ " " ^ word)
  in
  let paints = in_percent paints
  and clear = in_percent (clear lobes)
  and mirror =
    match Color.largest mirror with
    | 0. -> []
    | part -> [ Words.percent part ^ " mirror" ]
  and glow =
    if Color.equal emission Color.black then [] else [ glow emission ]
  in
  let solid =
    if starts_with_mirror surface then mirror @ paints else paints @ mirror
  in
  "mix of " ^ Words.list (solid @ clear @ glow)

let luminous emission =
  match Color_word.of_glow emission with
  | true, word -> "faintly luminous " ^ word
  | false, word -> "luminous " ^ word

let mirror part =
  if part = 1. then "mirror" else Words.percent part ^ " mirror"

(* How the name of a shape goes with its look, and how it stands by itself. *)
let names ?primitive number (o : Object.t) whence =
  match (primitive : Explain.primitive option) with
  | None ->
      ( Printf.sprintf "%s (object %d%s)" (Shape.name o.shape) number
          (place whence),
        Printf.sprintf "(%s %d%s)" (Shape.name o.shape) number (place whence)
      )
  | Some { is_taken_away = true; _ } ->
      let name = by_number ?primitive number o whence in
      let prefix = String.length "the " in
      ( String.sub name prefix (String.length name - prefix),
        Printf.sprintf "(%s)" name )
  | Some ({ object_; place = at; _ } as primitive) ->
      let whole = at_place (name o (string_of_int number)) whence in
      let number = number_of number primitive in
      ( Printf.sprintf "%s (object %s%s) of %s" (Shape.name object_.shape)
          number (place at) whole,
        Printf.sprintf "(%s) of %s" (name object_ number ^ place at) whole )

(* Words that go before the name of a shape, or stand for it. *)
let look surface =
  let lobes = Surface.lobes surface in
  let paints = paints surface in
  let glows = not (Color.equal lobes.emission Color.black) in
  match (paints @ clear lobes, Color.largest lobes.mirror, glows) with
  | [ { word; part = 1. } ], 0., false -> `Before word
  | [], 0., true -> `Before (luminous lobes.emission)
  | [], 0., false -> `Before "black"
  | [], part, false -> `Instead (mirror part)
  | _ -> `Instead (mix surface paints lobes)

let by_look ?primitive number o surface whence =
  let called, in_brackets = names ?primitive number o whence in
  match look surface with
  | `Before look -> look ^ " " ^ called
  | `Instead look -> look ^ " " ^ in_brackets

let here surface ~here =
  let what =
    match look here with `Before look -> look | `Instead look -> Words.a look
  in
  Printf.sprintf "the %s is %s" (Surface.name surface) what

let background c = Color_word.of_color c ^ " background"
