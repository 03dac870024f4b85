% SLURMQUEUE  Asks Slurm once about all arrays of a plan.
%
% CALL: [OK, TEXT] = slurmQueue (NAMES)
%
%   NAMES  1 x b cell of job names
%   OK     logical; false = no answer, which says nothing about the jobs
%   TEXT   input of slurmParse, or what squeue complained about
%
% Arrays are asked for by name, not by number: an unknown number is an error
% for squeue, an unknown name is not. Ended jobs are listed as long as the
% controller remembers them (MinJobAge).
%
% See also: slurmParse

function [ok, text] = slurmQueue (names)
  command = ['timeout 60 squeue --noheader --array --states=all ' ...
             '--user="$(id -u)" --format="%j|%K|%T|%r" --name='];
  [status, text] = system ([command, shellQuote(strjoin (names, ',')), ...
                            ' 2>&1']);
  ok = status == 0;
end

%!test
%! tidy = slurmFake ('false', 'echo "$@"');
%! [ok, text] = slurmQueue ({'a', 'b'});
%! assert (ok);
%! assert (! isempty (strfind (text, '--name=a,b')));
%!test
%! tidy = slurmFake ('false', 'echo "no contact" >&2; exit 1');
%! [ok, text] = slurmQueue ({'a'});
%! assert (! ok);
%! assert (text, "no contact\n");
