(* Functions on lists in constant stack, for those of MathComp's seq.v that are not (Extraction.v): the
   list of all worlds with 7 edges, or an answer with a million darts, would not fit into the stack.  Each
   applies its argument to the elements from left to right. *)
let cat s1 s2 = match s1, s2 with [], s | s, [] -> s | _ -> List.rev_append (List.rev s1) s2
let rcons s x = List.rev_append (List.rev s) [x]
let map f s = List.rev (List.rev_map f s)
let filter a s = List.rev (List.fold_left (fun kept x -> if a x then x :: kept else kept) [] s)
let pmap f s =
  List.rev (List.fold_left (fun kept x -> match f x with Some y -> y :: kept | None -> kept) [] s)
let foldr f z s = List.fold_left (fun z x -> f x z) z (List.rev s)
let iota m n =
  let rec from i s = if i <= m then s else from (i - 1) ((i - 1) :: s) in
  from (m + n) []
