(* The extracted folding: each line {"first": percept, "steps": [[motion, percept], ...]} is answered by
   {"folds": no dart is open, "sigma", "alpha", "here"}: the folded map, where alpha[d] = d says that d
   is open.  A percept has "degree" and "bearing" (null where the marker is not). *)
open Certified

let percept p =
  (Json.int (Json.field "degree" p),
   match Json.field "bearing" p with Json.Null -> None | b -> Some (Json.int b))

let step = function
  | Json.List [k; p] -> (Json.int k, percept p)
  | _ -> raise (Json.Malformed "a step [motion, percept] expected")

let () =
  try
    while true do
      let line = Json.parse (input_line stdin) in
      let steps = match Json.field "steps" line with
        | Json.List _ as l -> Json.list step l | _ -> raise (Json.Malformed "steps expected") in
      let first = percept (Json.field "first" line) in
      if List.exists (fun (k, (d, _)) -> k < 0 || d < 1) ((0, first) :: steps) then
        raise (Json.Malformed "motions from 0 on and degrees from 1 on expected");
      let folds, map = folded_log first steps in
      Printf.printf "{\"folds\":%b,\"sigma\":%s,\"alpha\":%s,\"here\":%d}\n%!" folds
        (Json.show map.sigma_list) (Json.show map.alpha_list) map.root_number
    done
  with
  | End_of_file -> ()
  | Json.Malformed why -> prerr_endline why; exit 2
