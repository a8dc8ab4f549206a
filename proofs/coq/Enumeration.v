(* ---------------------------------------------------------------------------------------------
   Every connected rooted map with m edges, once each.                                   Section V

   A rooted map is written down in one way only if its darts are numbered in the order of a
   breadth-first search from the root (RootedMaps.v).  The search is run without knowing the map: dart by
   dart it is decided where sigma and alpha lead, to a dart that has a number already or to the next
   number.  Each choice that contradicts none of those before is followed.

     sigma_choices, alpha_choices   where sigma, alpha of the next dart may lead.
     codes n fuel c s a   all ways to go on from the lists s and a, c darts having a number.
     canonical M          M is numbered in the order of the search from its root.
     rooted_maps m        the list of the canonical numbered_maps with m edges.

     rooted_maps_sound       every member is a map, connected, with m edges.
     rooted_maps_complete    every connected map with m edges, seen from any of its darts, is in
                             the list.
     rooted_maps_distinct    two members that are the same rooted map are the same member;
     rooted_maps_uniq        and none is listed twice.
     counts                  2, 10, 74, 706, 8162 for m = 1..5.
   compare_enumeration.py compares the list with that of the Python enumerator, map by map.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The decision tree ---- *)
Section Tree.
Variable n : nat.

(* s, a: what sigma and alpha of the darts 0, 1, ... are, as far as decided; c: so many darts have a
   number *)
Definition sigma_choices c (s : seq nat) := [seq x <- iota 0 (minn n c.+1) | x \notin s].
Definition alpha_choices c (a : seq nat) :=
  let k := size a in
  if k \in a then [:: index k a] else [seq y <- iota k.+1 (minn n c.+1 - k.+1) | y \notin a].

Fixpoint codes fuel c s a : seq (seq nat * seq nat) :=
  if fuel is fuel'.+1 then
    if size s < c then
      flatten [seq flatten [seq codes fuel' (maxn (maxn c x.+1) y.+1) (rcons s x) (rcons a y)
                           | y <- alpha_choices (maxn c x.+1) a]
              | x <- sigma_choices c s]
    else [::]
  else [:: (s, a)].

Lemma codes_prefix fuel c s a t : t \in codes fuel c s a ->
  (forall i, i < size s -> nth 0 t.1 i = nth 0 s i) /\
    (forall i, i < size a -> nth 0 t.2 i = nth 0 a i).
Proof.
elim: fuel c s a => [|fuel IH] c s a /=; first by rewrite inE => /eqP->.
case: ifP => // _ /flattenP[_ /mapP[x _ ->]] /flattenP[_ /mapP[y _ ->]] /IH[H1 H2].
by split=> i li; [rewrite H1 | rewrite H2]; rewrite ?size_rcons ?ltnS ?(ltnW li) // nth_rcons li.
Qed.

Lemma codes_size fuel c s a t : t \in codes fuel c s a -> size t.1 = size s + fuel.
Proof.
elim: fuel c s a => [|fuel IH] c s a /=; first by rewrite inE addn0 => /eqP->.
case: ifP => // _ /flattenP[_ /mapP[x _ ->]] /flattenP[_ /mapP[y _ ->]] /IH ->.
by rewrite size_rcons addSnnS.
Qed.

Lemma uniq_flatten (T U : eqType) (f : T -> seq U) (s : seq T) :
  uniq s -> (forall x, uniq (f x)) -> (forall x y z, z \in f x -> z \in f y -> x = y) ->
  uniq (flatten [seq f x | x <- s]).
Proof.
move=> us uf d; elim: s us => //= x s IH /andP[xs us]; rewrite cat_uniq uf IH // andbT.
apply/hasPn=> z /flattenP[_ /mapP[y ys ->]] zy; apply/negP=> zx.
by rewrite (d _ _ _ zx zy) ys in xs.
Qed.

Lemma codes_uniq fuel c s a : uniq (codes fuel c s a).
Proof.
elim: fuel c s a => //= fuel IH c s a; case: ifP => // _.
apply: uniq_flatten; first by rewrite filter_uniq ?iota_uniq.
  move=> x; apply: uniq_flatten => //.
    by rewrite /alpha_choices; case: ifP => // _; rewrite filter_uniq ?iota_uniq.
  move=> y y' z /codes_prefix[_ /(_ (size a))] H /codes_prefix[_ /(_ (size a))] H'.
  move: H H'; rewrite !size_rcons !nth_rcons !ltnn !eqxx => H H'.
  by rewrite -H // H'.
move=> x x' z /flattenP[_ /mapP[y _ ->]] /codes_prefix[/(_ (size s)) H _].
move=> /flattenP[_ /mapP[y' _ ->]] /codes_prefix[/(_ (size s)) H' _].
move: H H'; rewrite !size_rcons !nth_rcons !ltnn !eqxx => H H'.
by rewrite -H // H'.
Qed.
End Tree.

(* ---- The list ---- *)
Definition numbered_map_data M := (sigma_list M, alpha_list M, root_number M).
Definition numbered_map_of d := NumberedMap d.1.1 d.1.2 d.2.
Lemma numbered_map_dataK : cancel numbered_map_data numbered_map_of. Proof. by case. Qed.
Definition numbered_map_eqMixin := CanEqMixin numbered_map_dataK.
Canonical numbered_map_eqType := EqType numbered_map numbered_map_eqMixin.


(* numbered in the order of the search from dart 0 *)
Definition canonical M := (root_number M == 0) && (dart_order M == iota 0 (size (sigma_list M))).

Definition rooted_maps m : seq numbered_map :=
  [seq M <- [seq NumberedMap t.1 t.2 0 | t <- codes m.*2 m.*2 1 [::] [::]]
    | valid M && canonical M].

(* ---- Every canonical code is in the tree ---- *)
Section Found.
Variables (M : numbered_map).
Hypotheses (V : valid M) (K : canonical M).
Local Notation n := (size (sigma_list M)).
Local Notation s := (sigma_list M).
Local Notation a := (alpha_list M).
Let wf := validP V.

Let sizes : size a = n.
Proof. by case/and5P: V => /eqP. Qed.

Lemma insert_iota x c : c <= n -> (exists r, insert x (iota 0 c) ++ r = iota 0 n) ->
  x <= c /\ insert x (iota 0 c) = iota 0 (maxn c x.+1).
Proof.
move=> cn [r E]; rewrite /insert in E *; case: ifP E => [|/negbT].
  by rewrite mem_iota /= => lx _; rewrite (maxn_idPl lx) ltnW.
rewrite mem_iota /= -leqNgt => le; rewrite cat_rcons => E.
have xE : x = c.
  have lt : c < size (iota 0 n) by rewrite -E size_cat size_iota /= addnS ltnS leq_addr.
  have := congr1 (fun l => nth 0 l c) E; rewrite nth_cat size_iota ltnn subnn /= nth_iota //.
  by rewrite -[n in _ < n](size_iota 0).
by rewrite xE leqnn (maxn_idPr (leqnSn c)) -addn1 iotaD /= cats1.
Qed.

Lemma breadth_first_extends fuel i o : exists r,
  o ++ r = breadth_first (nth 0 s) (nth 0 a) fuel i o.
Proof.
elim: fuel i o => [|fuel IH] i o /=; first by exists [::]; rewrite cats0.
case: ifP => _; last by exists [::]; rewrite cats0.
set o' := insert (nth 0 a _) _; have [r E] := IH i.+1 o'; rewrite -E {E}.
have ext x (l : seq nat) : exists r', insert x l = l ++ r'.
  by rewrite /insert; case: ifP => _; [exists [::]; rewrite cats0 | exists [:: x]; rewrite cats1].
have [r2 E2] := ext (nth 0 s (nth 0 o i)) o; have [r1 E1] := ext (nth 0 a (nth 0 o i)) (o ++ r2).
by rewrite /o' E2 E1 -!catA; eexists.
Qed.

Lemma found fuel k c : k + fuel = n -> c <= n ->
  breadth_first (nth 0 s) (nth 0 a) fuel k (iota 0 c) = iota 0 n ->
  (s, a) \in codes n fuel c (take k s) (take k a).
Proof.
elim: fuel k c => [|fuel IH] k c kn cn /=.
  by rewrite addn0 in kn; rewrite kn take_size -sizes take_size inE.
have lk : k < n by rewrite -kn addnS ltnS leq_addr.
have la : k < size a by rewrite sizes.
rewrite size_iota size_takel ?(ltnW lk) //; case: ifP => [kc|]; last first.
  move=> /negbT; rewrite -leqNgt => ck /(congr1 size); rewrite !size_iota => cE.
  by move: lk; rewrite ltnNge -cE ck.
rewrite nth_iota // add0n => E.
set x := nth 0 s k in E *; set y := nth 0 a k in E *.
have xn : x < n by apply: (wellformed_sigma wf).
have yn : y < n by apply: (wellformed_alpha wf).
have [r Er] := breadth_first_extends fuel k.+1 (insert y (insert x (iota 0 c))).
have ext z (l : seq nat) : exists r', insert z l = l ++ r'.
  by rewrite /insert; case: ifP => _; [exists [::]; rewrite cats0 | exists [:: z]; rewrite cats1].
have [|xc xE] := @insert_iota x c cn.
  have [r' Er'] := ext y (insert x (iota 0 c)); exists (r' ++ r).
  by rewrite catA -Er' Er E.
have c1n : maxn c x.+1 <= n by rewrite geq_max cn.
rewrite xE in Er E; have [|yc yE] := @insert_iota y _ c1n; first by exists r; rewrite Er E.
rewrite yE in E; have c2n : maxn (maxn c x.+1) y.+1 <= n by rewrite geq_max c1n.
have := IH k.+1 _ _ c2n E; rewrite addSnnS => /(_ kn).
rewrite (take_nth 0 lk) (take_nth 0 la) -/x -/y => F.
have xs : x \notin take k s.
  apply/negP=> /(nthP 0)[j]; rewrite size_takel ?(ltnW lk) // => lj; rewrite nth_take //.
  move/(wellformed_inj wf (ltn_trans lj lk) lk) => jk; by rewrite jk ltnn in lj.
apply/flattenP; eexists; first apply: (@map_f _ _ _ _ x).
  by rewrite mem_filter xs mem_iota /= add0n leq_min xn ltnS xc.
apply/flattenP; eexists; first apply: (@map_f _ _ _ _ y); last exact: F.
have aK j : j < n -> nth 0 a (nth 0 a j) = j by exact: (wellformed_alphaK wf).
have kk : nth 0 a y = k by exact: aK.
have yk : y <> k by apply: (wellformed_alpha_neq wf).
rewrite /alpha_choices size_takel ?(ltnW la) //; case: ifP => [|/negbT] ka.
  have /(nthP 0)[j] := ka; rewrite size_takel ?(ltnW la) // => lj; rewrite nth_take // => jk.
  have yj : y = j by rewrite /y -jk aK // (ltn_trans lj lk).
  have ua : uniq (take k a).
    apply/(uniqP 0)=> u v; rewrite !inE size_takel ?(ltnW la) // => lu lv; rewrite !nth_take // =>
      uv.
    by rewrite -(aK u (ltn_trans lu lk)) uv aK // (ltn_trans lv lk).
  have ik : index k (take k a) = j.
    rewrite -[X in index X _]jk -(nth_take 0 lj) index_uniq //.
    by rewrite size_takel // ltnW.
  by rewrite inE ik yj.
rewrite mem_filter mem_iota; apply/and3P; split.
- apply/negP=> /(nthP 0)[j]; rewrite size_takel ?(ltnW la) // => lj; rewrite nth_take // => jy.
  have jk : j = k by rewrite -kk -jy aK // (ltn_trans lj lk).
  by rewrite jk ltnn in lj.
- rewrite ltn_neqAle eq_sym; apply/andP; split; first exact/eqP.
  rewrite leqNgt; apply: contra ka => yk'; apply/(nthP 0); exists y; rewrite ?nth_take //.
  by rewrite size_takel // ltnW.
rewrite subnKC; first by rewrite leq_min yn ltnS yc.
by rewrite leq_min lk ltnS /= (leq_trans (ltnW kc)) // leq_maxl.
Qed.

Theorem canonical_listed m : n = m.*2 -> M \in rooted_maps m.
Proof.
move=> nm; have n0 : 0 < n by apply: leq_ltn_trans (wellformed_root wf).
case/andP: (K) => /eqP r0 /eqP o; rewrite mem_filter V K /=; apply/mapP; exists (s, a).
  rewrite -nm -[X in X \in _]/(s, a); have := @found n 0 1 (add0n n) n0; rewrite !take0; apply.
  by move: o; rewrite /dart_order r0.
by case: (M) r0 => ? ? ? /= ->.
Qed.
End Found.

(* ---- Every rooted map has a canonical numbering ---- *)
Section Renumber.
Variable M : numbered_map.
Hypotheses (V : valid M) (C : connected (denote M)).
Local Notation n := (size (sigma_list M)).
Local Notation o := (dart_order M).
Let wf := validP V.

Definition renumbered := NumberedMap (code M).1 (code M).2 0.

Lemma renumbered_isomorphic : isomorphic (denote M) (denote renumbered).
Proof.
have sz := dart_order_full V C; have [A U] := dart_order_ok V.
have mem x := mem_dart_order x V sz.
have sR : size (sigma_list renumbered) = n by rewrite /= size_map.
exists (fun x => index x o), (nth 0 o); split.
- move=> x /= lx; rewrite size_map index_mem mem nth_index ?mem //.
  have li : index x o < size o by rewrite index_mem mem.
  by split=> //; rewrite (nth_map 0) // nth_index ?mem.
- move=> y /=; rewrite size_map => ly; split; last exact: index_uniq.
  by rewrite -mem mem_nth.
have [t ->] : exists t, o = root_number M :: t; last by rewrite /= eqxx.
rewrite /dart_order; have [r <-] := breadth_first_extends M n 0 [:: root_number M].
by exists r.
Qed.

Lemma renumbered_valid : valid renumbered.
Proof.
have sz := dart_order_full V C; have [A U] := dart_order_ok V.
have mem x := mem_dart_order x V sz.
have sR : size (sigma_list renumbered) = n by rewrite /= size_map.
apply: validI; last by rewrite /= !size_map.
apply: (isomorphic_wellformed (isomorphic_sym wf renumbered_isomorphic) wf) => /=;
  rewrite size_map sz.
- by apply: leq_ltn_trans (wellformed_root wf).
- move=> x lx; rewrite (nth_map 0) ?sz // -sz index_mem mem; apply: (wellformed_sigma wf).
  by rewrite /= -mem mem_nth ?sz.
move=> x lx; rewrite (nth_map 0) ?sz // -sz index_mem mem; apply: (wellformed_alpha wf).
by rewrite /= -mem mem_nth ?sz.
Qed.

Lemma renumbered_canonical : canonical renumbered.
Proof.
have sz := dart_order_full V C; have [A U] := dart_order_ok V.
have mem x := mem_dart_order x V sz.
rewrite /canonical /= size_map sz; apply/eqP.
have [t ot] : exists t, o = root_number M :: t.
  rewrite /dart_order; have [r <-] := breadth_first_extends M n 0 [:: root_number M]; by exists r.
have -> : dart_order renumbered = map (index^~ o) o.
  have r0 : [:: 0] = map (index^~ o) [:: root_number M] by rewrite /= ot /= eqxx.
  rewrite /dart_order [root_number renumbered]/= r0 [size (sigma_list renumbered)]/= size_map sz.
  apply: (breadth_first_image (n := n)).
  - exact: (wellformed_sigma wf).
  - exact: (wellformed_alpha wf).
  - by move=> x y lx ly /(congr1 (nth 0 o)); rewrite !nth_index ?mem.
  - move=> x lx /=; rewrite (nth_map 0) ?index_mem ?mem // nth_index ?mem //.
  - move=> x lx /=; rewrite (nth_map 0) ?index_mem ?mem // nth_index ?mem //.
  by rewrite /= andbT; exact: (wellformed_root wf).
apply: (@eq_from_nth _ 0); first by rewrite size_map size_iota.
move=> i; rewrite size_map => li; rewrite (nth_map 0) // index_uniq // nth_iota // -sz.
by [].
Qed.
End Renumber.

(* ---- The list is complete and free of repeats ---- *)
Section List.
Variable m : nat.

Lemma listed M : M \in rooted_maps m -> valid M /\ canonical M.
Proof. by rewrite mem_filter => /andP[/andP[]]. Qed.

Theorem rooted_maps_sound M : M \in rooted_maps m ->
  [/\ valid M, connected (denote M) & size (sigma_list M) = m.*2].
Proof.
move=> lM; have [V /andP[_ /eqP o]] := listed lM; split=> //.
  by apply/(connectedP V); rewrite o size_iota.
by move: lM; rewrite mem_filter => /andP[_ /mapP[t /codes_size s ->]].
Qed.

Lemma index_number i k : i < k -> index i (iota 0 k) = i.
Proof.
move=> li; have := @nth_iota 0 0 _ _ li; rewrite add0n => {1}<-.
by rewrite index_uniq ?size_iota ?iota_uniq.
Qed.

Theorem rooted_maps_distinct M N : M \in rooted_maps m -> N \in rooted_maps m ->
  isomorphic (denote M) (denote N) -> M = N.
Proof.
move=> lM lN I; have [_ C _] := rooted_maps_sound lM.
have [VM /andP[/eqP rM /eqP oM]] := listed lM; have [VN /andP[/eqP rN /eqP oN]] := listed lN.
have /and3P[_ _ /eqP] := same_code_complete VM VN C I.
have codeE K : valid K -> dart_order K = iota 0 (size (sigma_list K)) -> code K =
  (sigma_list K, alpha_list K).
  move=> VK oK; have W := validP VK; have sa : size (alpha_list K) =
    size (sigma_list K) by case/and5P: VK => /eqP.
  rewrite /code /relabel oK; congr (_, _); apply: (@eq_from_nth _ 0);
    rewrite ?size_map ?size_iota //.
    move=> i li; rewrite (nth_map 0) ?size_iota // nth_iota // add0n index_number //.
    exact: (wellformed_sigma W).
  move=> i li; rewrite (nth_map 0) ?size_iota // nth_iota // add0n index_number //.
  exact: (wellformed_alpha W).
rewrite !codeE //; case: (M) (N) rM rN => [? ? ?] [? ? ?] /= -> -> [-> ->].
by [].
Qed.

Theorem rooted_maps_uniq : uniq (rooted_maps m).
Proof.
apply: filter_uniq; rewrite map_inj_uniq ?codes_uniq //.
by move=> [s a] [s' a'] [-> ->].
Qed.

Theorem rooted_maps_complete (G : combinatorial_map) (d : G) : edges G = m ->
  exists2 M, M \in rooted_maps m & isomorphic (rooted d) (denote M).
Proof.
move=> Em; have [e ue me] : exists2 e : seq G, uniq e & forall x, x \in e.
  by exists (enum G) => [|x]; rewrite ?enum_uniq ?mem_enum.
pose N := NumberedMap [seq index (sigma x) e | x <- e] [seq index (alpha x) e | x <- e] (index d e).
have lt x : index x e < size e by rewrite index_mem.
have I : isomorphic (rooted d) (denote N).
  exists (index^~ e), (nth d e); split=> //= [x _|y].
    by rewrite size_map !(nth_map d) ?lt // !nth_index.
  by rewrite size_map => ly; rewrite index_uniq.
have VN : valid N.
  apply: validI; last by rewrite /= !size_map.
  apply: (isomorphic_wellformed (isomorphic_sym (rooted_wellformed d) I) (rooted_wellformed d)).
  - by rewrite /= size_map.
  - by move=> x /=; rewrite size_map => lx; rewrite (nth_map d) // lt.
  by move=> x /=; rewrite size_map => lx; rewrite (nth_map d) // lt.
have CN : connected (denote N).
  apply: (isomorphic_connected (validP VN) (isomorphic_sym (rooted_wellformed d) I)).
  exact: rooted_connected.
exists (renumbered N); last exact: isomorphic_trans I (renumbered_isomorphic VN CN).
apply: canonical_listed; [exact: renumbered_valid | exact: renumbered_canonical |].
rewrite /= size_map (dart_order_full VN CN) /= size_map -Em edges_double -(card_uniqP ue).
by apply: eq_card => x; rewrite me.
Qed.
End List.

(* ---- The counts ---- *)
Set Warnings "-abstract-large-number".
Theorem counts : [seq size (rooted_maps m) | m <- iota 1 5] = [:: 2; 10; 74; 706; 8162].
Proof. by vm_compute. Qed.
