open Raylab_source
open Raylab_geometry
open Raylab_expression

type failure = { fault : Fault.t; trail : Trail.t; point : Vec3.t }

exception Failed of failure

type 'thing make =
  'thing Value.run -> Expression.t -> 'thing Value.t array -> 'thing Value.t

let start ~make code = Closed.start ~describe:(fun _ -> "a surface") ~make code

let value machine point read =
  match read (Closed.run machine) (Closed.value machine point) with
  | value -> value
  | exception Fault.Found fault ->
      raise (Failed { fault; trail = Closed.trail machine; point })

let told files ?pixel { fault = { message; advice; _ }; trail; point } =
  let at =
    Format.asprintf "at the point %a%s" Vec3.pp point
      (Option.fold pixel ~none:"" ~some:(fun (x, y) ->
           Printf.sprintf ", in pixel (%d, %d)" x y))
  in
  let lines = Steps.tell files trail @ [ at ] in
  let lines = if advice = "" then lines else lines @ [ advice ] in
  (Printable.text message, List.map Printable.text lines)

(* {1 Reading values} *)

let shown (e : Expression.t) x =
  match e.desc with
  | Number _ -> Expression.to_string e
  | _ ->
      Printf.sprintf "%s, which is %s" (Expression.to_string e)
        (Format.asprintf "%a" Number.pp x)

let require rule name (e : Expression.t) x =
  match Number.broken rule x with
  | None -> ()
  | Some problem ->
      Fault.fail e.span
        (Printf.sprintf "%s %s, not %s" name problem (shown e x))

let number rule name run e value =
  let x = Operation.number run e value in
  require rule name e x;
  x

let color name run (e : Expression.t) value =
  let { Vec3.x; y; z } = Operation.vector run e value in
  if x >= 0. && y >= 0. && z >= 0. then Color.make x y z
  else
    let r, g, b =
      match e.desc with
      | Triple (r, g, b) | List [ r; g; b ] -> (r, g, b)
      | _ -> (e, e, e)
    in
    let channel part e x =
      require Non_negative (Printf.sprintf "the %s of %s" part name) e x
    in
    channel "red" r x;
    channel "green" g y;
    channel "blue" b z;
    Color.make x y z
