# Mistakes on the command line.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_tencer.cmake)

run_tencer(target ellipse --vertices 24 -o ring.obj)
expect_status(0)

refused("a command is missing; use one of design, feasible, " "(see tencer --help)")
refused("there is no 'desing' here" "did you mean design?" desing ring.obj)
refused("there is no 'paint' here" "use one of design, feasible, " paint ring.obj)
refused("INPUT is required" "(see tencer design --help)" design)
refused("there is no option --nosuch" "(see tencer design --help)" design ring.obj -o out --nosuch)
refused("there is no option --max-eror (did you mean --max-error?)" "(see tencer design --help)"
  design ring.obj -o out --max-eror 3)
refused("there is no option --optmizer (did you mean --optimizer?) and --colsed (did you mean --closed?)"
  "(see tencer design --help)" design --optmizer mma ring.obj --colsed)
refused("'more.obj' is too much" "(see tencer design --help)" design ring.obj more.obj -o out)
refused("--cables: its value is missing" "(see tencer design --help)" design ring.obj --cables)
foreach(value 0 -1 nan inf small)
  refused("--max-error: " "expected a positive number, found ${value}"
    design ring.obj -o out --max-error ${value})
  refused("--tolerance: " "expected a positive number, found ${value}"
    simulate design.json --tolerance ${value})
endforeach()
refused("--view: expected a direction x,y,z that is not zero" "such as 0,0,1"
  design ring.obj -o out --view 0,0,0)
refused("--view: " "(see tencer design --help)" design ring.obj -o out --view 0,1)
refused("--optimizer: " "use one of gauss-newton, " design ring.obj -o out --optimizer bfgs)
refused("--optimizer: " "did you mean ipopt?" design ring.obj -o out --optimizer IPOPT)
refused("--hessian: " "limited-memory, gauss-newton, exact" design ring.obj -o out --hessian full)
refused("--from: " "pose" simulate design.json --from here)
refused("--cables: " "inextensible" simulate design.json --cables ropes)
foreach(value 0 1.5 1001)
  refused("--refine: " "${value}" simulate design.json --refine ${value})
endforeach()
foreach(value -1 nan inf some)
  refused("--length-error: " "expected a number that is not negative, found ${value}"
    check design.json --length-error ${value})
endforeach()
refused("--max-deviation: " "expected a positive number in %, mm, cm or m, found 0"
  check design.json --max-deviation 0)
refused("none.json: " "there is no such file" check none.json -o out)
foreach(option --joint --knot)
  refused("${option}: " "expected a length in mm, cm or m, found -1"
    fabricate design.json ${option} -1)
endforeach()
foreach(value 0 nan 2ft)
  refused("--stock: " "expected a length above zero in mm, cm or m, found ${value}"
    fabricate design.json --stock ${value})
endforeach()
refused("--paper: " "did you mean a4?" fabricate design.json --paper a3)
refused("--price-rod: " "expected a positive number, found 0" fabricate design.json --price-rod 0)
refused("none.json: " "there is no such file" fabricate none.json -o out)
refused("none.json: " "there is no such file" view none.json -o page.html)
if(MMA)
  refused("--hessian: " "belongs to the optimizer ipopt"
    design ring.obj -o out --optimizer mma --hessian exact)
endif()
foreach(value 0 -1 2.5 many 99999999999)
  refused("--cables: " "expected a positive whole number, found ${value}"
    design ring.obj -o out --cables ${value})
  refused("--threads: " "expected a positive whole number, found ${value}"
    design ring.obj -o out --threads ${value})
endforeach()
refused("--time: " "expected a positive number, found 0" design ring.obj -o out --time 0)
refused("--effort: " "4 not in range 1 to 3" design ring.obj -o out --effort 4)
refused("none.json: " "there is no such file" design ring.obj -o out --from none.json)
refused("--keep: " "expected a positive whole number, found 0"
  design ring.obj -o out --from none.json --keep 0)
refused("--material: " "glass fibre, carbon" design ring.obj -o out --material cheese)
refused("--method: " "force-balance, dense-springs" design ring.obj -o out --method luck)
refused("--objective: " "max, rms" design ring.obj -o out --objective worst)
refused("--symmetry: " "none, offer, detect" design ring.obj -o out --symmetry mirror)

# Options that do not go together.
refused("--cables: " "drop --cables" design ring.obj -o out --trade-off --cables 5)
refused("--forbid: " "name it with --from" design ring.obj -o out --forbid 2)
refused("--add: " "one number of cables, --trade-off for all"
  design ring.obj -o out --trade-off --from none.json --add 1)
refused("--hessian: " "belong to the method dense-springs" design ring.obj -o out --hessian exact)
refused("--symmetry: " "use none, or --method force-balance"
  design ring.obj -o out --method dense-springs --symmetry detect)

# Where the result cannot be written is found out before the work.
refused("ring.obj: " "cannot be made a folder: ring.obj is a file" design ring.obj -o ring.obj)
refused("ring.obj/out: " "cannot be made a folder: ring.obj is a file"
  design ring.obj -o ring.obj/out)

# The tables name the optimizers that were built.
if(IPOPT AND MMA)
  check_page("Command lines")
endif()
