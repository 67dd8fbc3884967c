type t = Syntax.included

let nothing =
  let header_end = { Raylab_source.Span.start = 0; stop = 0 } in
  let syntax = { Syntax.header = []; header_end; items = [] } in
  { Syntax.base = -1; names = []; syntax }
