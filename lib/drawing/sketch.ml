type t = { marks : Drawing.t; busy : Rectangle.t list; labels : Label.t list }

let marks marks = { marks; busy = []; labels = [] }
let busy rectangle marks = { marks; busy = [ rectangle ]; labels = [] }
let label label = { marks = []; busy = []; labels = [ label ] }

let all sketches =
  {
    marks = List.concat_map (fun s -> s.marks) sketches;
    busy = List.concat_map (fun s -> s.busy) sketches;
    labels = List.concat_map (fun s -> s.labels) sketches;
  }

let finish panel { marks; busy; labels } =
  marks @ Label.arrange panel ~busy labels
