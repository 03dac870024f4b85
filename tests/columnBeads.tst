% Columns of beads whose changes were told afterwards: examples/columnBeads.
% Series 4 has 2 % of water and series 2 has 5 %, series 3 is as dry as the
% reference. A regression test alone: nothing is chosen on these series.

%!test
%! if strcmp (getenv ('DECALIOC_SOAK'), '1')
%!   pkg load stk
%!   root = fileparts (which ('DEcalioc'));
%!   folder = fullfile (root, 'examples', 'columnBeads');
%!   home = cd (folder);
%!   back = onCleanup (@() cd (home));
%!   Case = withEffects (loadCase (root, folder));
%!   data = importRuns (fullfile (folder, 'storedRuns.csv'), Case);
%!   for c = 1:numel (Case.conditions)
%!     given = newProblem (Case, [], c);
%!     d = diagnoseMatrices (given, data, struct ('bootstrap', 49));
%!     printf ('%s: %s (%s), p %.2g, class %s, decides %s\n', ...
%!             Case.conditions{c}, d.which.verdict, ...
%!             strjoin (d.which.effects, ', '), d.which.gateP, ...
%!             strjoin (d.which.class, ', '), strjoin (d.which.decides, ', '));
%!     if strcmp (Case.conditions{c}, 'series3')
%!       assert (d.which.verdict, 'no gap');
%!     else
%!       assert (any (ismember ({'cohesion', 'waterBridge', 'oilBridge'}, ...
%!                              d.which.class)));
%!     end
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
