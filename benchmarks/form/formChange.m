% FORMCHANGE  The campaign of hiddenEffect as one of changes, friction listed.
%
% CALL: [GIVEN, DATA, PAIRS] = formChange (ROOT)
%
%   ROOT   folder of the toolbox
%   GIVEN  struct for newProblem, with three effects more: sliding, wall and
%          rolling friction raised by half of the box
%   DATA   all runs of hiddenEffect. Ten neutral ones for each friction are
%          there once more, as runs of that effect: a set whose friction was
%          raised from a lower one is what it is, whoever asked for it
%   PAIRS  runs without an effect, as importRuns gives them, at the parameters
%          of runs that DATA hold (results/changePairs.csv)
%
% See also: formStudy, lawSwap

function [given, data, pairs] = formChange (root)
  [given, data] = storedCampaign ('hiddenEffect', root);
  home = cd (fullfile (root, 'examples', 'hiddenEffect'));
  back = onCleanup (@() cd (home));
  Case = withEffects (loadCase (root, pwd ()));
  pairs = importRuns (fullfile (root, 'benchmarks', 'results', ...
                                'changePairs.csv'), Case);
  given.held(:) = false;
  neutral = neutralEffects (Case);
  columns_ = 2:4;
  names = {'sliding', 'wallFriction', 'rolling'};
  v = columns (data.E);
  plain = find (all (data.E == neutral, 2) & all (isfinite (data.Z), 2));
  data.E = [data.E, zeros(rows (data.E), 3)];
  for f = 1:3
    j = columns_(f);
    most = diff (given.limits(:, j)) / 2;
    given.effects = [given.effects, ...
                     newEffect(struct ('name', names{f}, 'variables', ...
                                       {names(f)}, 'neutral', 0, 'limits', ...
                                       [0; most]), numel (given.value))];
    high = plain(data.X(plain, j) > given.limits(1, j) + 0.3 * most);
    own = keepRows (data, high(round (linspace (1, numel (high), 10))));
    room = min (own.X(:, j) - given.limits(1, j), most);
    raised = room .* linspace (1, 0.4, 10)';
    own.X(:, j) = own.X(:, j) - raised;
    own.E(:, v + f) = raised;
    for field = fieldnames (data)'
      data.(field{1}) = [data.(field{1}); own.(field{1})];
    end
  end
end

% SPDX-License-Identifier: GPL-3.0-only
