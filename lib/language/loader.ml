open Raylab_source

type t = {
  sources : Sources.t;
  inclusions : (Span.t * Sources.file) list;
  missing : string list;
  taken : Taken.t list;
  syntax : (Syntax.t, Scene_error.t list) result;
}

let most_nested = 100

(* Offsets are as large as this where integers have 32 bits. *)
let max_size = 0x7fff_ffff

(* The files that are being read, the innermost first, and where each is
   included. *)
type chain = (string * Span.t) list

type state = {
  access : Access.t;
  mutable sources : Sources.t;
  read : (string, Sources.file * Syntax.included) Hashtbl.t; (* by identity *)
  included : (int, Syntax.included) Hashtbl.t; (* by the place *)
  mutable inclusions : (Span.t * Sources.file) list;
  mutable missing : string list;
  mutable taken : Taken.t list list;
  mutable errors : Scene_error.t list;
  mutable refused : int; (* how many files *)
}

(* Nobody reads more of them. *)
let most_refused = 1_000

let error state span ?advice message =
  let error = Scene_error.make state.sources span ?advice message in
  state.errors <- error :: state.errors;
  state.refused <- state.refused + 1;
  Included.nothing

let named name = Printf.sprintf "'%s'" (Printable.text name)

(* {1 Circles} *)

(* The links of the circle that goes back to the file of this identity. *)
let rec circle identity (chain : chain) =
  match chain with
  | [] -> None
  | (id, _) :: _ when id = identity -> Some []
  | (_, span) :: rest ->
      Option.map (fun spans -> span :: spans) (circle identity rest)

let told_circle state spans =
  let link span =
    let place = Sources.place state.sources span in
    Printf.sprintf "%s includes %s in line %d"
      (Printable.text (Sources.name state.sources span.Span.start))
      (Sources.quote state.sources span)
      place.line
  in
  String.concat ",\n" (List.map link spans)

(* {1 Files} *)

(* Explanations do not depend on the folder in which one works. *)
let name state path =
  let main = Sources.file state.sources 0 in
  Option.value ~default:path (Access.below (Filename.dirname main.path) path)

let rec parse state chain (file : Sources.file) =
  let before = state.errors in
  let include_ = include_ state chain file in
  match Reader.parse ~include_ state.sources file with
  | Ok { included; taken } ->
      state.taken <- taken :: state.taken;
      included
  | Error error ->
      (* what lacks a file may lack its names *)
      if state.errors == before then state.errors <- error :: before;
      Included.nothing

and include_ state chain (file : Sources.file) span name =
  match Hashtbl.find_opt state.included span.start with
  | Some included -> included
  | None when state.refused > most_refused -> Included.nothing
  | None when state.refused = most_refused ->
      error state span "more files cannot be included than are told"
  | None ->
      let included = find state chain file span name in
      Hashtbl.add state.included span.start included;
      included

and find state chain file span name =
  let refused { Access.message; advice } =
    state.missing <- Access.join ~from:file.path name :: state.missing;
    error state span
      (Printf.sprintf "%s cannot be included: %s" (named name)
         (Printable.text message))
      ~advice:(Printable.text advice)
  in
  match state.access.find ~from:file.path name with
  | Error refusal -> refused refusal
  | Ok found -> (
      match circle found.identity chain with
      | Some spans ->
          let spans = List.rev (span :: spans) in
          error state span "files include each other in a circle"
            ~advice:(told_circle state spans)
      | None when List.length chain > most_nested ->
          error state span
            (Printf.sprintf "files are included deeper than %d" most_nested)
      | None -> (
          match fetch state chain span found with
          | Ok (file, included) ->
              state.inclusions <- (span, file) :: state.inclusions;
              included
          | Error refusal -> refused refusal))

and fetch state chain span (found : Access.found) =
  match Hashtbl.find_opt state.read found.identity with
  | Some read -> Ok read
  | None ->
      let limit = max_size - Sources.size state.sources in
      let read text =
        state.sources <-
          Sources.add ~path:found.path ~name:(name state found.path) text
            state.sources;
        let last = Files.last (Sources.table state.sources) in
        let file = Sources.file state.sources last in
        let included = parse state ((found.identity, span) :: chain) file in
        Hashtbl.add state.read found.identity (file, included);
        (file, included)
      in
      Result.map read (state.access.read ~limit found)

let read access sources =
  let state =
    {
      access;
      sources;
      read = Hashtbl.create 7;
      included = Hashtbl.create 7;
      inclusions = [];
      missing = [];
      taken = [];
      errors = [];
      refused = 0;
    }
  in
  let main = Sources.file sources 0 in
  let nowhere = { Span.start = 0; stop = 0 } in
  let identity = Option.value access.Access.main ~default:"-" in
  let { Syntax.syntax; _ } = parse state [ (identity, nowhere) ] main in
  let { sources; inclusions; missing; taken; errors; _ } = state in
  let syntax =
    match errors with [] -> Ok syntax | errors -> Error (List.rev errors)
  in
  let by_place (_, a) (_, b) = Int.compare a b in
  {
    sources;
    inclusions = List.rev inclusions;
    missing = List.rev missing;
    taken = List.sort by_place (List.concat taken);
    syntax;
  }
