% TWINSSCORE  Scores the verdicts of the twin study and writes every case.
%
% CALL: twinsScore (NAME, TWINS, VERDICTS, LABS, LINESOF)
%
%   NAME      path without ending: NAME.csv (cases), NAME-scores.csv (figures)
%   TWINS, VERDICTS, LABS  of twinsDraw, twinsDiagnose, twinsLaboratories
%   LINESOF   handle, LINES = linesOf (S): the figures of a study from the flags
%             of twinsFlags, see foreignLines (those of twins)
%
% Prints the figures of merit with 95 % Clopper-Pearson intervals; twinsCurves
% gives them over the signal to noise d.
%
% See also: twins, writeShares

function twinsScore (name, twins, verdicts, labs, linesOf)
  if nargin < 5
    linesOf = @standInLines;
  end
  s = twinsFlags (twins, verdicts);
  s.score = scoresOf (twins, verdicts);
  writeCases ([name, '.csv'], twins, verdicts, labs, s);
  writeShares ([name, '-scores.csv'], linesOf (s));
  addScores ([name, '-scores.csv'], s.score);
  printf ('median %.2f s a diagnosis, longest %.2f s\n', ...
          median ([verdicts.seconds]), max ([verdicts.seconds]));
end

function lines = standInLines (s)
  strong = s.single & s.d >= 3.9;
  listed = s.named & ~s.out;
  lines = {'false naming on null', s.named, s.null, '<= 0.05'; ...
           'top-1, d >= 4', s.top, strong, '>= 0.90'; ...
           'top-1 or in the reported group, d >= 4', s.top | s.right, ...
           strong, '>= 0.90'; ...
           'named or grouped rightly, d >= 4', s.right, strong, ''; ...
           'precision of names, listed causes', s.right, listed, '>= 0.95'; ...
           'precision of names, all cases', s.right, s.named, ''; ...
           'wrong name, out of library', s.named, s.out, '<= 0.05'; ...
           'wrong name, out of library, d >= 4', s.named, ...
           s.out & s.d >= 3.9, ''; ...
           'none of the listed, out of library, d >= 4', s.unlisted, ...
           s.out & s.d >= 3.9, ''; ...
           'pair: names or groups only true effects', s.clean, s.pair, ''; ...
           'pair: both named', s.both, s.pair, ''; ...
           '90 % interval of strength holds it', s.covered, s.single, ...
           '0.85 - 0.95'; ...
           'a gap was seen, d >= 4', ~s.noGap, strong, ''};
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
        at = 1;
      case 'single'
        at = 1 + twins(i).cause;
      case 'pair'
        at = K + 2;
      otherwise
        at = K + 3;
    end
    truth = (1:K + 3) == at;
    score(i, :) = [log(max (P(at), 1e-6)), sum((P - truth).^2), ...
                   log(prior(at)), sum((prior - truth).^2)];
  end
end

function addScores (file, score)
  average = mean (score, 1);
  names = {'log score', 'Brier score', 'log score of the prior', ...
           'Brier score of the prior'};
  id = fopen (file, 'a');
  for k = 1:4
    fprintf (id, '%s,,%d,%.4f,,,\n', names{k}, rows (score), average(k));
    printf ('%-55s %.3f\n', names{k}, average(k));
  end
  fclose (id);
end

function writeCases (file, twins, verdicts, labs, s)
  id = fopen (file, 'w');
  fprintf (id, ['case,lab,class,cause,removed,d,phi,verdict,effects,top,', ...
                'right,covered,odds20,lookAlike,like,cosine,gateP,', ...
                'excludeOdds,', ...
                'pNull,pTop,pPair,pUnlisted,logScore,brier,seconds\n']);
  for i = 1:numel (twins)
    t = twins(i);
    v = verdicts(i);
    names = {labs(t.lab).gapProblem.effects.name};
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
    fprintf (id, '%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.3f,%.3f,%.2f\n', v.gateP, ...
             exp (min (v.exclude, 20)), v.P(1), v.P(1 + v.top), ...
             v.P(end - 1), v.P(end), s.score(i, 1:2), v.seconds);
  end
  fclose (id);
end

%!test % one null that is named, by the table of the stand-ins and by another
%! name = tempname ();
%! labs = struct ('name', 'here', 'gapProblem', ...
%!                struct ('effects', struct ('name', {'a', 'b'})));
%! twin = struct ('lab', 1, 'class', 'null', 'cause', [], 'removed', 0, ...
%!                'phi', [0, 0], 'd', 0, 'dEach', [], 'like', 0, 'cosine', NaN);
%! verdict = struct ('kind', 'named', 'effects', 2, 'top', 2, 'P', ...
%!                   [0.1, 0, 0.9, 0, 0], 'interval', zeros (2, 3), 'gateP', ...
%!                   0.01, 'exclude', 0.5, 'seconds', 1, 'lookAlike', true);
%! evalc ('twinsScore (name, twin, verdict, labs);');
%! scores = fileread ([name, '-scores.csv']);
%! cases = fileread ([name, '.csv']);
%! other = @(s) {'seen', s.gate, s.null, '<= 1'};
%! evalc ('twinsScore (name, twin, verdict, labs, other);');
%! own = fileread ([name, '-scores.csv']);
%! delete ([name, '-scores.csv'], [name, '.csv']);
%! assert (~isempty (strfind (scores, 'false naming on null,1,1,1.0000')));
%! assert (~isempty (strfind (own, 'seen,1,1,1.0000,0.0250,1.0000,<= 1')));
%! assert (~isempty (strfind (cases, '1,here,null,,0,0.000,,named,b,b,0,0')));
