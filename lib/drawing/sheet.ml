type part =
  | Free of Drawing.t
  | Panel of {
      name : string;
      box : Rectangle.t;
      paper : Drawing.look;
      drawing : Drawing.t;
    }

type t = { width : float; height : float; title : string; parts : part list }
