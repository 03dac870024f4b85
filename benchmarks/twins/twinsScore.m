% TWINSSCORE  Scores the verdicts of the twin study and writes every case.
%
% CALL: twinsScore (NAME, TWINS, VERDICTS, LABS)
%
%   NAME      path without ending: NAME.csv gets the cases
%   TWINS, VERDICTS, LABS  of twinsDraw, twinsDiagnose, foreignTwins
%
% See also: foreignTwins, gapTables, scoreDiagnoses

function twinsScore (name, twins, verdicts, labs)
  for i = 1:numel (twins)
    cases(i) = caseOf (twins(i), verdicts(i), labs(twins(i).lab));
  end
  s = scoreDiagnoses (cases);
  s.odds = [cases.odds];
  s.score = scoresOf (twins, verdicts);
  s.mark = [cases.mark];
  s.kind = [cases.kind];
  s.isKind = [cases.isKind];
  writeCases ([name, '.csv'], twins, verdicts, labs, s);
  printf ('median %.2f s a diagnosis, longest %.2f s\n', ...
          median ([verdicts.seconds]), max ([verdicts.seconds]));
end

% What scoreDiagnoses asks for and the table needs; effects by number.
% odds: posterior odds of the true one, or of something that resembles it, above
% 20 to 1. dLeast: d of the weakest cause alone. mark: of a name, largest cosine
% of the true mark, without what parameters absorb, with that of a named effect.
% kind: the verdict says what kind of cause it is, by a name or by a group whose
% marks are nearly the same; isKind: each effect it says has such a mark.
function c = caseOf (twin, verdict, lab)
  words = @(numbers) arrayfun (@num2str, numbers, 'UniformOutput', false);
  cause = twin.cause(twin.cause > 0);
  c = struct ('class', twin.class, 'cause', {words(cause)}, 'd', twin.d, ...
              'verdict', verdict.kind, 'effects', {words(verdict.effects)}, ...
              'top', num2str (verdict.top), 'phi', twin.phi(cause), ...
              'interval', [], 'odds', false, 'lab', twin.lab, ...
              'cosine', twin.cosine, 'dLeast', min ([twin.dEach, Inf]), ...
              'gateP', verdict.gateP, 'lookAlike', verdict.lookAlike, ...
              'mark', NaN, 'causeName', '', 'kind', false, 'isKind', false);
  isNamed = strcmp (verdict.kind, 'named');
  c.kind = isNamed || verdict.sameKind;
  if c.kind && twin.d > 0
    marks = twinsMark (twin, verdict.effects, lab);
    c.isKind = all (marks >= 0.9 | ismember (verdict.effects, cause));
    if isNamed
      c.mark = max (marks);
    end
  end
  if ~isempty (cause)
    c.causeName = strjoin ({lab.problem.effects(cause).name}, ' ');
  end
  if twin.removed > 0
    c.cause = {};
  end
  if strcmp (twin.class, 'single')
    c.interval = verdict.interval(cause, 2:3);
    p = verdict.total(cause);
    c.odds = p > 20 * (1 - p);
  end
end

% Cosine (1 x m) of the true mark of a twin with that of each of EFFECTS (numbers) at
% a quarter, half and full strength (both ways where it acts so), without what
% parameters absorb, in units of the noise: the largest. The laws are asked, not the
% surrogates.
function cosine = twinsMark (twin, effects, lab)
  space = twinsSpace (lab, twin.theta);
  see = @(Z) (space.factor \ (Z - space.base)')' * space.free;
  mark = see (lab.means (twin.theta, twin.phi) + twin.alien);
  cosine = zeros (1, numel (effects));
  for i = 1:numel (effects)
    k = effects(i);
    strength = [1; 0.5; 0.25];
    strength = [strength; -strength(1:3 * lab.isSigned(k))];
    phi = strength * ((1:numel (lab.isSigned)) == k);
    own = see (lab.means (ones (rows (phi), 1) * twin.theta, phi));
    cosine(i) = max (own * mark' ./ max (norm (mark) * ...
                                         norm (own, 'rows'), realmin));
  end
end

% Log and Brier score of the truth among null, effects, pair and unlisted, and
% those of the prior: n x 4.
function score = scoresOf (twins, verdicts)
  n = numel (twins);
  score = zeros (n, 4);
  for i = 1:n
    P = verdicts(i).P;
    K = numel (P) - 3;
    prior = [0.4, 0.4 / K * ones(1, K), 0.1, 0.1];
    switch twins(i).class
      case 'null'
        place = 1;
      case 'single'
        place = 1 + twins(i).cause;
      case 'pair'
        place = K + 2;
      otherwise
        place = K + 3;
    end
    truth = (1:K + 3) == place;
    score(i, :) = [log(max (P(place), 1e-6)), sum((P - truth).^2), ...
                   log(prior(place)), sum((prior - truth).^2)];
  end
end

function writeCases (file, twins, verdicts, labs, s)
  id = fopen (file, 'w');
  fprintf (id, "%s\n", originLines (){:});
  fprintf (id, ['case,lab,class,cause,removed,d,phi,verdict,effects,top,', ...
                'right,covered,odds20,lookAlike,like,cosine,gateP,', ...
                'mark,kind,isKind,', ...
                'pNull,pTop,pPair,pUnlisted,logScore,brier,seconds\n']);
  for i = 1:numel (twins)
    t = twins(i);
    v = verdicts(i);
    names = {labs(t.lab).problem.effects.name};
    truth = 'alien';
    if ~isequal (t.cause, 0)
      truth = strjoin (names(t.cause), ' ');
    end
    cause = t.cause(t.cause > 0);
    fprintf (id, '%d,%s,%s,%s,%d,%.3f,%s,%s,%s,%s,%d,%d,%d,%d,', i, ...
             labs(t.lab).name, t.class, truth, t.removed, t.d, ...
             strtrim (sprintf ('%.3f ', t.phi(cause))), v.kind, ...
             strjoin (names(v.effects), ' '), names{v.top}, s.right(i), ...
             s.covered(i), s.odds(i), v.lookAlike);
    fprintf (id, '%s,%.2f,', strjoin (names(t.like(t.like > 0)), ' '), ...
             t.cosine);
    fprintf (id, '%.4g,%.2f,%d,%d,', v.gateP, s.mark(i), s.kind(i), ...
             s.isKind(i));
    fprintf (id, '%.4g,%.4g,%.4g,%.4g,%.3f,%.3f,%.2f\n', v.P(1), ...
             v.P(1 + v.top), ...
             v.P(end - 1), v.P(end), s.score(i, 1:2), v.seconds);
  end
  fclose (id);
end

%!test % one null that is named
%! name = tempname ();
%! labs = struct ('name', 'here', 'problem', ...
%!                struct ('effects', struct ('name', {'a', 'b'})));
%! twin = struct ('lab', 1, 'class', 'null', 'cause', [], 'removed', 0, ...
%!                'phi', [0, 0], 'd', 0, 'dEach', [], 'like', 0, 'cosine', NaN);
%! verdict = struct ('kind', 'named', 'effects', 2, 'top', 2, 'P', ...
%!                   [0.1, 0, 0.9, 0, 0], 'interval', zeros (2, 3), 'gateP', ...
%!                   0.01, 'seconds', 1, 'lookAlike', true, ...
%!                   'sameKind', false);
%! evalc ('twinsScore (name, twin, verdict, labs);');
%! cases = fileread ([name, '.csv']);
%! delete ([name, '.csv']);
%! assert (~isempty (strfind (cases, '1,here,null,,0,0.000,,named,b,b,0,0')));
%!test % a group of one kind, each of which has the mark of the true cause
%! name = tempname ();
%! labs = foreignLab (2);
%! labs.noise = sqrt (labs.noiseSd.^2 + labs.problem.sd.^2);
%! twin = twinsDraw (labs, 1, twinsMix ('singles'));
%! verdict = struct ('kind', 'group', 'effects', twin.cause * [1, 1], 'top', ...
%!                   twin.cause, 'P', ones (1, numel (twin.phi) + 3) / 9, ...
%!                   'interval', zeros (numel (twin.phi), 3), 'total', ...
%!                   zeros (size (twin.phi)), 'gateP', 0.01, ...
%!                   'seconds', 1, 'lookAlike', false, 'sameKind', true);
%! evalc ('twinsScore (name, twin, verdict, labs);');
%! [header, cells] = readCsvTable ([name, '.csv']);
%! delete ([name, '.csv']);
%! assert (cells(ismember (header, {'mark', 'kind', 'isKind'})), ...
%!         {'NaN', '1', '1'});

% SPDX-License-Identifier: GPL-3.0-only
