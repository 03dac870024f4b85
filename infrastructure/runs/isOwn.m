% ISOWN  Rows of the table that this calibration has run itself.
%
% CALL: YES = isOwn (DATA)
%
% DATA  struct of newData
% YES   n x 1 logical; false for rows of runs.csv, where a missing result may
%       mean that its model was not run: they tell nothing of failures
%
% See also: failedSets, runPlan, checkSurrogates

function yes = isOwn (data)
  yes = ~strcmp (data.stage(:), 'import');
end

%!assert (isOwn (struct ('stage', {{'import'; 'plan'}})), [false; true])
