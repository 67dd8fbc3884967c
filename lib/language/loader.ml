open Raylab_source

type t = {
  sources : Sources.t;
  named : (Span.t * string) list;
  missing : string list;
  taken : Taken.t list;
  meshes : Raylab_geometry.Mesh.t list;
  unused : Raylab_scene.Warning.t list;
  syntax : (Syntax.t, Scene_error.t list) result;
}

let most_nested = 100

(* Offsets are as large as this where integers have 32 bits. *)
let max_size = 0x7fff_ffff

type state = {
  access : Access.t;
  mutable sources : Sources.t;
  read : (string, Sources.file * Syntax.included) Hashtbl.t; (* by identity *)
  included : (int, Syntax.included) Hashtbl.t; (* by the place *)
  models : Models.t;
  meshes : (int, Raylab_mesh_file.Model.t) Hashtbl.t; (* by the place *)
  mutable named : (Span.t * string) list;
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
  state.refused <- state.refused + 1

let named name = Printf.sprintf "'%s'" (Printable.text name)

(* {1 Files} *)

(* Explanations do not depend on the folder in which one works. *)
let name_of state path =
  let main = Sources.file state.sources 0 in
  Option.value ~default:path (Access.below (Filename.dirname main.path) path)

let refused state (file : Sources.file) span name verb refusal =
  let { Access.message; advice } = refusal in
  state.missing <- Access.join ~from:file.path name :: state.missing;
  error state span
    (Printf.sprintf "%s cannot be %s: %s" (named name) verb
       (Printable.text message))
    ~advice:(Printable.text advice)

(* What is named at a place, found once, and as long as that is told. *)
let at_place state known span verb nothing find =
  match Hashtbl.find_opt known span.Span.start with
  | Some found -> found
  | None when state.refused > most_refused -> nothing
  | None when state.refused = most_refused ->
      error state span
        (Printf.sprintf "more files cannot be %s than are told" verb);
      nothing
  | None ->
      let found = Option.value ~default:nothing (find ()) in
      Hashtbl.add known span.start found;
      found

let read_limited state found =
  let limit = max_size - Sources.size state.sources in
  state.access.read ~limit found

(* {1 Meshes} *)

let model state (file : Sources.file) span name =
  let attach (found : Access.found) bytes =
    state.sources <- Sources.attach ~path:found.path bytes state.sources;
    bytes
  in
  let find (found : Access.found) =
    Models.find state.models ~at:span.Span.start
      ~name:(name_of state found.path)
      (fun () -> Result.map (attach found) (read_limited state found))
      found
  in
  match Result.bind (state.access.find ~from:file.path name) find with
  | Ok (model, path) ->
      state.named <- (span, path) :: state.named;
      Some model
  | Error refusal ->
      refused state file span name "read" refusal;
      None

let mesh state file span name =
  at_place state state.meshes span "read" Raylab_mesh_file.Model.nothing
    (fun () -> model state file span name)

(* {1 Files that are included} *)

let rec parse state chain (file : Sources.file) =
  let before = state.errors in
  let files =
    { Lexer.include_ = include_ state chain file; mesh = mesh state file }
  in
  match Reader.parse ~files state.sources file with
  | Ok { included; taken } ->
      state.taken <- taken :: state.taken;
      included
  | Error error ->
      (* what lacks a file may lack its names *)
      if state.errors == before then state.errors <- error :: before;
      Included.nothing

and include_ state chain (file : Sources.file) span name =
  at_place state state.included span "included" Included.nothing (fun () ->
      find state chain file span name)

and find state chain file span name =
  let refused = refused state file span name "included" in
  match state.access.find ~from:file.path name with
  | Error refusal ->
      refused refusal;
      None
  | Ok found -> (
      match Circle.find found.identity chain with
      | Some spans ->
          let spans = List.rev (span :: spans) in
          error state span "files include each other in a circle"
            ~advice:(Circle.told state.sources spans);
          None
      | None when List.length chain > most_nested ->
          error state span
            (Printf.sprintf "files are included deeper than %d" most_nested);
          None
      | None -> (
          match fetch state chain span found with
          | Ok (file, included) ->
              state.named <- (span, file.Sources.path) :: state.named;
              Some included
          | Error refusal ->
              refused refusal;
              None))

and fetch state chain span (found : Access.found) =
  match Hashtbl.find_opt state.read found.identity with
  | Some read -> Ok read
  | None ->
      let read text =
        state.sources <-
          Sources.add ~path:found.path ~name:(name_of state found.path) text
            state.sources;
        let last = Files.last (Sources.table state.sources) in
        let file = Sources.file state.sources last in
        let included = parse state ((found.identity, span) :: chain) file in
        Hashtbl.add state.read found.identity (file, included);
        (file, included)
      in
      Result.map read (read_limited state found)

let read access sources =
  let state =
    {
      access;
      sources;
      read = Hashtbl.create 7;
      included = Hashtbl.create 7;
      models = Models.start ();
      meshes = Hashtbl.create 7;
      named = [];
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
  let { sources; named; missing; taken; errors; models; _ } = state in
  let syntax =
    match errors with [] -> Ok syntax | errors -> Error (List.rev errors)
  in
  let by_place (_, a) (_, b) = Int.compare a b in
  {
    sources;
    named = List.rev named;
    missing = List.rev missing;
    taken = List.sort by_place (List.concat taken);
    meshes = Models.meshes models;
    unused = Models.warnings models;
    syntax;
  }
