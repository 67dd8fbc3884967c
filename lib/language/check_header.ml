open Raylab_source
open Raylab_geometry
open Raylab_scene
open Raylab_expression

type t = {
  check : Check.t;
  mutable seen : (string * Span.t) list;
  mutable numbers : (string * float) list;
  mutable background : Color.t option;
}

let start check = { check; seen = []; numbers = []; background = None }
let required = [ "imWidth"; "imHeight"; "canvWidth"; "canvHeight"; "depth" ]

(* Of a number that is written, its text decides: 1.0 is not whole. *)
let is_whole sources (e : Expression.t) x =
  match e.desc with
  | Number _ ->
      let text = Sources.slice sources e.span in
      let is_digit c = '0' <= c && c <= '9' in
      let digits =
        match text.[0] with
        | '+' | '-' -> String.sub text 1 (String.length text - 1)
        | _ -> text
      in
      String.for_all is_digit digits
  | _ -> Float.is_integer x

let whole header scope name ~least ~most (e : Expression.t) frame =
  let sources = Findings.sources (Check.findings header.check) in
  let code = Code.number scope e in
  Check.attempt header.check frame 1. (fun () ->
      let x = code frame in
      if
        is_whole sources e x
        && x >= float_of_int least
        && x <= float_of_int most
      then x
      else
        let found =
          match e.desc with
          | Number _ -> Sources.quote sources e.span
          | _ ->
              Printf.sprintf "%s, which is %s" (Expression.to_string e)
                (Format.asprintf "%a" Number.pp x)
        in
        Fault.fail e.span
          (Printf.sprintf "%s must be a whole number from %d to %d, not %s"
             name least most found))

let value header scope { Syntax.word; value = e; _ } frame =
  let number x = header.numbers <- (word, x) :: header.numbers in
  match word with
  | "imWidth" | "imHeight" ->
      number (whole header scope word ~least:1 ~most:Camera.max_size e frame)
  | "raydepth" ->
      number
        (whole header scope word ~least:0 ~most:Scene.max_ray_depth e frame)
  | "bcolor" ->
      header.background <- Some (Check.color header.check scope word e frame)
  | _ -> number (Check.number header.check scope Positive word e frame)

let set header scope setting frame =
  let { Syntax.word; word_span; _ } = setting in
  let findings = Check.findings header.check in
  value header scope setting frame;
  match List.assoc_opt word header.seen with
  | Some first ->
      let place = Sources.place (Findings.sources findings) first in
      Findings.error findings word_span
        (Printf.sprintf "%s is set a second time" word)
        ~advice:
          (Printf.sprintf "it is already set in line %d; remove one of them"
             place.line)
  | None -> header.seen <- (word, word_span) :: header.seen

let finish header stop =
  let missing =
    List.filter (fun name -> not (List.mem_assoc name header.seen)) required
  in
  if missing <> [] then
    Findings.error
      (Check.findings header.check)
      stop
      (Printf.sprintf "the header lacks %s" (String.concat ", " missing))
      ~advice:
        "every scene starts with imWidth, imHeight, canvWidth, canvHeight and \
         depth, each followed by a number"

let scene header ~files ~lights ~objects =
  let number word = List.assoc word header.numbers in
  let whole word = int_of_float (number word) in
  let camera =
    Camera.make ~width:(whole "imWidth") ~height:(whole "imHeight")
      ~canvas_width:(number "canvWidth") ~canvas_height:(number "canvHeight")
      ~depth:(number "depth")
  in
  let ray_depth =
    Option.map int_of_float (List.assoc_opt "raydepth" header.numbers)
  in
  Scene.make camera ?background:header.background ?ray_depth ~files ~lights
    ~objects
