; Loop augmentation maintains I-2
; Says: If U stands for the unexplored edges at G_s, then it does so after e and the confirmed h
;   have left it: the edge just walked had exactly these two entries in U.
; Paper: V, step 2, last case ('Both the two edges are removed from U')
; Symbols:
;   Dart, MapDart   the darts of the world G; the darts of the map S
;   alpha, partner  the other end of the same edge, in G; in S, for explored darts
;   seen, walked    G_s, the explored subgraph: darts at its vertices, darts of its edges
;   known, explored the same of S: darts at its vertices, darts of its edges
;   open            the set U
;   phi, name       the isomorphism from S to G_s, and its inverse
;                   with 0: before the pass, with 1: after it, without: left alone by it
;   e, h            the dart explored in this pass, and the hypothesis that was confirmed
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-fun alpha (Dart) Dart)
(declare-fun seen (Dart) Bool)
(declare-fun known (MapDart) Bool)
(declare-fun phi (MapDart) Dart)
(declare-fun name (Dart) MapDart)
(declare-fun walked0 (Dart) Bool)
(declare-fun open0 (MapDart) Bool)
(declare-fun walked1 (Dart) Bool)
(declare-fun open1 (MapDart) Bool)
(declare-const e MapDart)
(declare-const h MapDart)

; I-1 before, as far as needed: phi carries the darts of S one to one to those at vertices of G_s
(assert (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x)))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
; I-2 before: phi carries U one to one to the unexplored darts at vertices of G_s
(assert (forall ((x MapDart)) (=> (open0 x) (and (known x) (not (walked0 (phi x)))))))
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked0 d))) (open0 (name d)))))
; the pass: e is taken from U, and the test of h in U proved that e and h are one edge
(assert (open0 e))
(assert (open0 h))
(assert (= (alpha (phi e)) (phi h)))
; the robot has walked that edge
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))))
; loop augmentation: e and h are removed from U
(assert (forall ((x MapDart)) (= (open1 x) (and (open0 x) (not (= x e)) (not (= x h))))))

; not: I-2 after
(assert (not (and
  (forall ((x MapDart)) (=> (open1 x) (and (known x) (not (walked1 (phi x))))))
  (forall ((d Dart)) (=> (and (seen d) (not (walked1 d))) (open1 (name d)))))))
(check-sat)
