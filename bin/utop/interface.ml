let table = lazy (Hashtbl.of_seq (List.to_seq Embedded.interfaces))
let read text : Cmi_format.cmi_infos = Marshal.from_string text 0
let find name = Option.map read (Hashtbl.find_opt (Lazy.force table) name)
