% ISAFTERPLAN  Rows of the table that were run after the plan.
%
% CALL: YES = isAfterPlan (DATA)
%
%   DATA  see newData
%   YES   n x 1 logical

function yes = isAfterPlan (data)
  yes = ~ismember (data.stage(:), {'import', 'plan'});
end

%!assert (isAfterPlan (struct ('stage', {{'import'; 'plan'; 'verify'}})), ...
%!        [false; false; true])
