open Raylab_geometry
open Raylab_scene
open Raylab_expression

type t = { findings : Findings.t; mutable failed : bool }
type frame = Thing.t Code.frame
type 'a parameter = frame -> 'a

let start findings = { findings; failed = false }
let findings check = check.findings

let attempt check (frame : frame) default f =
  let run = frame.run in
  let around = run.stack and depth = run.budget.depth in
  let fail () =
    run.stack <- around;
    run.budget.depth <- depth;
    check.failed <- true;
    default
  in
  match f () with
  | value -> value
  | exception Fault.Found ({ ends = false; _ } as fault) ->
      Findings.fault check.findings fault run.stack;
      fail ()
  | exception Fault.Known -> fail ()

let whole check build =
  let before = check.failed in
  check.failed <- false;
  match build () with
  | built ->
      let failed = check.failed in
      check.failed <- before;
      if failed then raise_notrace Fault.Known else built
  | exception e ->
      check.failed <- before;
      raise e

(* {1 Rules} *)

let shown check (e : Expression.t) x =
  match e.desc with
  | Number _ ->
      Raylab_source.Sources.quote (Findings.sources check.findings) e.span
  | _ ->
      Printf.sprintf "%s, which is %s" (Expression.to_string e)
        (Format.asprintf "%a" Number.pp x)

let require check rule name (e : Expression.t) x =
  match Number.broken rule x with
  | None -> ()
  | Some problem ->
      Fault.fail e.span
        (Printf.sprintf "%s %s, not %s" name problem (shown check e x))

let value check scope e =
  let code = Code.compile scope e in
  fun frame -> attempt check frame Value.Undefined (fun () -> code frame)

let number check scope rule name e =
  let code = Code.number scope e in
  fun frame ->
    attempt check frame 1. (fun () ->
        let x = code frame in
        require check rule name e x;
        x)

let part name part = Printf.sprintf "the %s of %s" part name

(* Three numbers, each with its own place if it has one. *)
let three check scope rule name (a, b, c) (e : Expression.t) =
  match e.desc with
  | Triple (x, y, z) | List [ x; y; z ] ->
      let number label e = number check scope rule (part name label) e in
      let x = number a x and y = number b y and z = number c z in
      fun frame ->
        let x = x frame in
        let y = y frame in
        let z = z frame in
        Vec3.make x y z
  | _ ->
      let code = Code.compile scope e in
      fun frame ->
        attempt check frame (Vec3.make 1. 1. 1.) (fun () ->
            let v = Operation.vector frame.Code.run e (code frame) in
            require check rule (part name a) e v.x;
            require check rule (part name b) e v.y;
            require check rule (part name c) e v.z;
            v)

let vector check scope name e = three check scope Finite name ("x", "y", "z") e

let direction check scope name (e : Expression.t) =
  let vector = vector check scope name e in
  fun frame ->
    let v = vector frame in
    attempt check frame (Vec3.make 0. 1. 0.) (fun () ->
        if Vec3.equal v Vec3.zero then
          Fault.fail e.span
            (name ^ " must not be the zero vector")
            ~advice:"give at least one number that is not 0, such as 0 1 0"
        else v)

let color check scope name e =
  let channels =
    three check scope Non_negative name ("red", "green", "blue") e
  in
  fun frame ->
    let { Vec3.x; y; z } = channels frame in
    Color.make x y z
