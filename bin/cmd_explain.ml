open Cmdliner
open Raylab_scene
open Raylab_tracer
open Raylab_explanation
open Raylab_drawing
open Raylab_picture

type form = Text | Json | Steps

type options = {
  scene : string;
  allow : string list;
  pixels : (int * int) list;
  view : Options.view;
  form : form;
  sample : int option;  (** counted from 1 *)
  svg : string option;
}

(* {1 Which pixels} *)

let check_pixel { Camera.width; height; _ } (x, y) =
  if not (0 <= x && x < width && 0 <= y && y < height) then
    Command.usage_error
      "pixel %d,%d is not in the picture: x is from 0 to %d, y from 0 to %d" x
      y (width - 1) (height - 1)

let check_extension path =
  match Extension.of_path path with
  | Ok ("" | ".svg") -> ()
  | Ok extension ->
      Command.usage_error
        "%s: the path of the rays is drawn as SVG, not as '%s'; use .svg" path
        extension
  | Error message -> Command.usage_error "%s" message

let check_svg options =
  match (options.svg, options.pixels) with
  | Some "", _ ->
      Command.usage_error "option --svg: the name of the file is empty"
  | Some _, _ :: _ :: _ ->
      Command.usage_error
        "option --svg: the picture is of the path of one pixel, not of several"
  | Some path, _ when Target.is_standard_output path && options.form <> Text ->
      Command.usage_error
        "option --svg: only one thing can go to standard output"
  | Some path, _ when Command.is_same_file path options.scene ->
      Command.usage_error "%s is the scene; the picture would replace it" path
  | Some path, _ -> check_extension path
  | None, _ -> ()

(* {1 What is said} *)

let swatches () =
  Swatch.detect ~is_terminal:(Unix.isatty Unix.stdout) Sys.getenv_opt

let check_sample options { Explain.x; y; samples; _ } =
  let taken = List.length samples in
  match options.sample with
  | Some k when k > taken ->
      Command.usage_error
        "option --sample: pixel %d,%d has %d sample%s, not %d" x y taken
        (if taken = 1 then "" else "s")
        k
  | _ -> ()

let text { sample; _ } pixels =
  let swatches = swatches () in
  let one = Format.asprintf "%a\n" (Report.pp_pixel_with ~swatches ?sample) in
  String.concat "\n" (List.map one pixels)

(* Of one sample, the centre unless another is asked for. *)
let steps { sample; _ } scene pixels =
  let k = Option.fold sample ~none:0 ~some:pred in
  let one (x, y) =
    let ray = Sample_ray.make scene.Prepared.scene ~x ~y k in
    let events = Explain.steps scene ray in
    let line k event = Format.asprintf "%4d  %a\n" (k + 1) Event.pp event in
    String.concat "" (List.of_seq (Seq.mapi line events))
  in
  match pixels with
  | [ pixel ] -> one pixel
  | _ ->
      let titled (x, y) =
        Printf.sprintf "pixel (%d, %d)\n%s" x y (one (x, y))
      in
      String.concat "\n" (List.map titled pixels)

let or_end = function
  | Ok value -> value
  | Error message -> Command.write_error message

let check_place path =
  or_end
    (if Target.is_standard_output path then Atomic_file.check_output ()
     else Atomic_file.check ~path ~bytes:1)

let written write = or_end (Signals.for_readers write)
let print text = written (fun () -> Atomic_file.print text)

let save_svg path text =
  let write channel = output_string channel text in
  match written (fun () -> Atomic_file.save ~path write) with
  | Whole -> ()
  | In_place _ as outcome -> Command.say "%s" (Atomic_file.wrote ~path outcome)

let explain options () =
  check_svg options;
  let reading, written =
    Command.read_scene ~allow:options.allow options.scene
  in
  let scene = Options.adjust options.view written in
  List.iter (check_pixel scene.camera) options.pixels;
  Option.iter (fun path -> Output.protect path reading) options.svg;
  Warnings.tell_as options.view options.scene reading;
  Option.iter check_place options.svg;
  let prepared = Prepared.make scene in
  let explained (x, y) = Explain.pixel prepared ~x ~y in
  let pixels = lazy (List.map explained options.pixels) in
  let pixels () = Lazy.force pixels in
  if Option.is_some options.sample then
    List.iter (check_sample options) (pixels ());
  let svg () =
    Path_picture.to_svg ?sample:options.sample scene (List.hd (pixels ()))
  and said () =
    match options.form with
    | Text -> text options (pixels ())
    | Json -> Json.to_string (Json.document (pixels ()))
    | Steps -> steps options prepared options.pixels
  in
  match options.svg with
  | None -> print (said ())
  | Some path when Target.is_standard_output path -> print (svg ())
  | Some path ->
      save_svg path (svg ());
      print (said ())

(* {1 The command line} *)

let pixel =
  let parse text =
    let whole = Printf.sprintf "%d,%d" in
    match Scanf.sscanf_opt text "%d,%d%!" (fun x y -> (x, y)) with
    | Some (x, y) when whole x y = text -> Ok (x, y)
    | _ ->
        Error
          (Printf.sprintf
             "'%s' is not a pixel: expected x, counted from the left, and y, \
              from the top, such as 320,240"
             text)
  in
  Options.conv parse ~docv:"X,Y" (fun ppf (x, y) ->
      Format.fprintf ppf "%d,%d" x y)

let sample_number =
  let parse text =
    match Options.natural text with
    | Some k when k >= 1 -> Ok k
    | _ ->
        Error
          (Printf.sprintf
             "'%s' is not the number of a sample; they count from 1" text)
  in
  Options.conv parse ~docv:"K" Format.pp_print_int

let options =
  let open Arg in
  let pixels =
    let doc =
      "The pixel: $(i,X) from the left and $(i,Y) from the top of the \
       picture, both counted from 0."
    in
    non_empty & pos_right 0 pixel [] & info [] ~docv:"X,Y" ~doc
  and form =
    let json =
      let doc = "Print JSON instead of text; see $(b,JSON) below." in
      (Json, info [ "json" ] ~doc)
    and steps =
      let doc =
        "Print the steps of the tracer instead, numbered, one a line, in the \
         order in which it takes them."
      in
      (Steps, info [ "steps" ] ~doc)
    in
    value & vflag Text [ json; steps ]
  and svg =
    let doc =
      "Draw the path of the rays, too, from above and from the side, and \
       write that as SVG to $(docv), which appears whole or not at all. \
       $(b,-) is standard output; nothing else goes there then. It takes one \
       pixel."
    in
    value & opt (some string) None & info [ "svg" ] ~docv:"FILE" ~doc
  in
  let sample =
    let doc =
      "Of a pixel with several samples, tell of sample $(docv), counted from \
       1, instead of one of each group that see the same. The first is the \
       centre."
    in
    value & opt (some sample_number) None & info [ "sample" ] ~docv:"K" ~doc
  in
  let make scene allow pixels view form sample svg =
    { scene; allow; pixels; view; form; sample; svg }
  in
  Term.(
    const make $ Command.scene_arg $ Options.allow $ pixels $ Options.view
    $ form $ sample $ svg)

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Says why pixels of the picture of $(i,SCENE) have their colours: a \
         summary, and then what the tracer did, ray by ray, and how the \
         colour is put together. It is not a second opinion: the rendering \
         itself is written down.";
      `P
        "On a terminal colours have a patch beside them, unless the \
         environment variable $(b,NO_COLOR) is set.";
      `S "JSON";
      `P
        "With $(b,--json) the output is one object, {\"version\": 2, \
         \"pixels\": [PIXEL, ...]}, where";
      `Pre Json_schema.text;
      `P
        "Objects and lights are numbered by their place in the scene, from 1; \
         $(b,line) is where the file has them. A NUMBER has all its digits; \
         it is null where the computation left the range of doubles. New \
         members may be added; a change that breaks readers gets a new \
         version.";
    ]
  in
  Cmd.v
    (Command.info "explain" ~doc:"say why pixels have their colours" man)
    (Command.run Term.(const explain $ options))
