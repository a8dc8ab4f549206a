; Each pass explores exactly one edge more: t falls
; Says: The edge walked in a pass has two darts, neither of them walked before; both are walked
;   after it, and nothing is forgotten. So |E_S| = |E_{G_s}| grows by one, in both augmentations.
; Paper: V, step 3 ('|E_S| is increased and thus t is decreased')
; Symbols:
;   Dart, MapDart   the darts of the world G; the darts of the map S
;   phi, name       the isomorphism from S to G_s, and its inverse
;   alpha           the other end of the same edge, in G
;   walked          the darts of the edges walked
;   open0           the set U before the pass
;   e               the dart explored in this pass
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-fun alpha (Dart) Dart)
(declare-fun phi (MapDart) Dart)
(declare-fun walked0 (Dart) Bool)
(declare-fun open0 (MapDart) Bool)
(declare-fun walked1 (Dart) Bool)
(declare-const e MapDart)

; an edge has two ends
(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
; and they are two darts
(assert (forall ((d Dart)) (not (= (alpha d) d))))
; I-1 before: the edges of G_s have two ends
(assert (forall ((d Dart)) (=> (walked0 d) (walked0 (alpha d)))))
; I-2 before: a dart of U is unexplored
(assert (forall ((x MapDart)) (=> (open0 x) (not (walked0 (phi x))))))
; the pass
(assert (open0 e))
; the robot has walked that edge
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))))

; not: two darts more, those of the edge of e, and none less
(assert (not (and
  (not (= (phi e) (alpha (phi e)))) (not (walked0 (phi e))) (not (walked0 (alpha (phi e))))
  (walked1 (phi e)) (walked1 (alpha (phi e)))
  (forall ((d Dart)) (=> (walked0 d) (walked1 d)))
  (forall ((d Dart)) (=> (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))))))
(check-sat)
