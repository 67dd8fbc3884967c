type t = {
  shapes : Svg.t list;
  marks : Rectangle.t list;
  labels : Label.t list;
}

let shapes shapes = { shapes; marks = []; labels = [] }
let mark rectangle shapes = { shapes; marks = [ rectangle ]; labels = [] }
let label label = { shapes = []; marks = []; labels = [ label ] }

let all drawings =
  {
    shapes = List.concat_map (fun d -> d.shapes) drawings;
    marks = List.concat_map (fun d -> d.marks) drawings;
    labels = List.concat_map (fun d -> d.labels) drawings;
  }

let draw view { shapes; marks; labels } =
  shapes @ Label.arrange view ~marks labels
