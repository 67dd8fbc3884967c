open Raylab_source

type t = { span : Span.t; message : string; advice : string; ends : bool }

exception Found of t
exception Known

let fail span ?(advice = "") message =
  raise (Found { span; message; advice; ends = false })

let stop span ?(advice = "") message =
  raise (Found { span; message; advice; ends = true })
