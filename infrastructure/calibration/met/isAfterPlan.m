% ISAFTERPLAN  Rows of the table that this case has run after the plan.
%
% CALL: YES = isAfterPlan (DATA)
%
%   YES   n x 1 logical

function yes = isAfterPlan (data)
  yes = ~ismember (data.stage(:), {'import', 'library', 'plan'});
end

%!assert (isAfterPlan (struct ('stage', {{'import'; 'library'; 'plan'; ...
%!                                        'verify'}})), [false(3, 1); true])

% SPDX-License-Identifier: GPL-3.0-only
