open Raylab_geometry
open Raylab_scene
open Raylab_expression

(* {1 Rules} *)

let shown check (e : Expression.t) x =
  match e.desc with
  | Number _ ->
      Raylab_source.Sources.quote
        (Findings.sources (Check.findings check))
        e.span
  | _ ->
      Printf.sprintf "%s, which is %s" (Expression.to_string e)
        (Format.asprintf "%a" Number.pp x)

let require check rule name (e : Expression.t) x =
  match Number.broken rule x with
  | None -> ()
  | Some problem ->
      Fault.fail e.span
        (Printf.sprintf "%s %s, not %s" name problem (shown check e x))

let number check scope rule name (e : Expression.t) : float Check.ready =
  match e.desc with
  | Number x when Number.broken rule x = None -> fun _ -> x
  | _ ->
      let code = Code.number scope e in
      fun frame ->
        Check.attempt check frame 1. (fun () ->
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
        Check.attempt check frame (Vec3.make 1. 1. 1.) (fun () ->
            let v = Operation.vector frame.Frame.run e (code frame) in
            require check rule (part name a) e v.x;
            require check rule (part name b) e v.y;
            require check rule (part name c) e v.z;
            v)

let vector check scope name e = three check scope Finite name ("x", "y", "z") e

let direction check scope name (e : Expression.t) =
  let vector = vector check scope name e in
  fun frame ->
    let v = vector frame in
    Check.attempt check frame (Vec3.make 0. 1. 0.) (fun () ->
        if Vec3.equal v Vec3.zero then
          Fault.fail e.span
            (name ^ " must not be the zero vector")
            ~advice:"give at least one number that is not 0, such as 0 1 0"
        else v)

(* A colour's word, which in brackets is the name of nothing else. *)
let color_word scope (e : Expression.t) =
  match e.desc with
  | Name name when Scope.find scope name = None ->
      List.assoc_opt (String.lowercase_ascii name) Color.names
  | _ -> None

let color check scope name e : Color.t Check.ready =
  match color_word scope e with
  | Some c -> fun _ -> c
  | None ->
      let channels =
        three check scope Non_negative name ("red", "green", "blue") e
      in
      fun frame ->
        let { Vec3.x; y; z } = channels frame in
        Color.make x y z

(* Of a number that is written, its text decides: 1.0 is not whole. *)
let is_whole sources (e : Expression.t) x =
  match e.desc with
  | Number _ ->
      let text = Raylab_source.Sources.slice sources e.span in
      let is_digit c = '0' <= c && c <= '9' in
      let digits =
        match text.[0] with
        | '+' | '-' -> String.sub text 1 (String.length text - 1)
        | _ -> text
      in
      String.for_all is_digit digits
  | _ -> Float.is_integer x

let whole_number check scope ~least ~most name (e : Expression.t) =
  let sources = Findings.sources (Check.findings check) in
  let code = Code.number scope e in
  let lies_within x = x >= float_of_int least && x <= float_of_int most in
  fun frame ->
    Check.attempt check frame least (fun () ->
        let x = code frame in
        if is_whole sources e x && lies_within x then int_of_float x
        else
          Fault.fail e.span
            (Printf.sprintf "%s must be a whole number from %d to %d, not %s"
               name least most (shown check e x)))

(* What is in it is made ready as well, so that what is wrong is told. *)
let pattern check scope name name_span (e : Expression.t) =
  let inner, _ = Scope.bind scope name name_span in
  let (_ : Thing.t Code.t) = Code.compile inner e in
  let none = { Closed.name; body = e; definitions = [] } in
  fun frame ->
    Check.attempt check frame none (fun () ->
        Evaluate_pattern.make
          ~thing:(fun _ -> None)
          scope ~at:e.span name e frame)

(* {1 What is written} *)

let parameter : type a.
    Check.t -> Scope.t -> a Written.parameter -> a Check.ready =
 fun check scope { name; kind; written } ->
  match kind with
  | Number rule -> number check scope rule name written
  | Whole { least; most } -> whole_number check scope ~least ~most name written
  | Vector -> vector check scope name written
  | Direction -> direction check scope name written
  | Color -> color check scope name written
  | Pattern { name; name_span } -> pattern check scope name name_span written

(* All parameters are evaluated before anything is made of them. *)
let rec parameters : type make made.
    Check.t ->
    Scope.t ->
    (make, made) Written.parameters ->
    (make -> made) Check.ready =
 fun check scope written ->
  match written with
  | [] -> fun _ made -> made
  | first :: rest ->
      let first = parameter check scope first
      and rest = parameters check scope rest in
      fun frame ->
        let first = first frame in
        let rest = rest frame in
        fun make -> rest (make first)

let compile check scope span ~default
    (Written.Written { parameters = written; make }) =
  let parameters = parameters check scope written in
  fun frame ->
    let build = parameters frame in
    if Check.failed check then default
    else
      try build make
      with Written.Refused { message; advice } ->
        Check.attempt check frame default (fun () ->
            Fault.fail span message ~advice)
