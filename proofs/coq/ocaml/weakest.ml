(* Tables of sensors, by the extracted checker of WeakestSensors.v.  'weakest --write' writes the kernel's.  Else
   each line of the input is a row: {"letters": six numbers, "twins": [] or two maps {"sigma", "alpha", "root"}}.
   Says how many suffice, which is proved of what passes; exit code 1 if the table does not pass. *)
open Certified

let naturals l = if List.for_all (fun x -> x >= 0) l then l else raise (Json.Malformed "a number is negative")
let numbers key j = naturals (Json.ints (Json.field key j))
let map j = { sigma_list = numbers "sigma" j; alpha_list = numbers "alpha" j;
              root_number = List.hd (naturals [Json.int (Json.field "root" j)]) }
let twins_of = function [] -> None | [m; n] -> Some (m, n) | _ -> raise (Json.Malformed "not two maps")
let row j = (numbers "letters" j, twins_of (Json.list map (Json.field "twins" j)))

let of_map m = Printf.sprintf "{\"sigma\":%s,\"alpha\":%s,\"root\":%d}" (Json.show m.sigma_list)
  (Json.show m.alpha_list) m.root_number
let written (l, t) = Printf.printf "{\"letters\":%s,\"twins\":[%s]}\n" (Json.show l)
  (match t with None -> "" | Some (m, n) -> of_map m ^ "," ^ of_map n)
let rec lines () = match input_line stdin with l -> l :: lines () | exception End_of_file -> []

let () =
  if Array.to_list Sys.argv |> List.mem "--write" then List.iter written (table_of twins) else
  match List.map (fun line -> row (Json.parse line)) (lines ()) with
  | rows when table_checks rows ->
      Printf.printf "%d of %d suffice\n" (List.length (List.filter (fun (_, t) -> t = None) rows)) (List.length rows)
  | _ -> print_endline "REFUSED"; exit 1
  | exception Json.Malformed why -> prerr_endline why; exit 2
